#pragma once

#include <vector>

#include "beadswim/core/vec3.hpp"
#include "svg.hpp"

namespace beadswim {

/// Central projection of a rectangular block onto a part of the page. The eye is in front of the block, a
/// little to the right and above. With the vector d = point - eye and the scalar product ".",
///   page point = (d.right, -d.up) / (d.forward) scale + shift
/// right, up and forward are the unit vectors of the directions of view.
class Perspective {
 public:
  /// Projects the block from `low` to `high` [length] into a rectangle of `width` x `height` px whose top
  /// left corner is `top_left`. The projection keeps its proportions and may not fill the rectangle.
  Perspective(const Vec3& low, const Vec3& high, svg::Point top_left, double width, double height);

  /// Returns the projection of a point onto the page.
  svg::Point project(const Vec3& point) const;
  double depth(const Vec3& point) const { return (point - eye_).dot(forward_); }  ///< from the eye [length]
  /// Returns the projected size [px] of a length that has the depth of the point.
  double projected_size(const Vec3& point, double length) const { return scale_ * length / depth(point); }
  double width() const { return width_; }    ///< width of the projected block [px]
  double height() const { return height_; }  ///< height of the projected block [px]

 private:
  Vec3 eye_, right_, up_, forward_;
  double scale_ = 1;
  svg::Point shift_{};
  double width_ = 0, height_ = 0;
};

/// Returns the 8 corners of a box. Bit a of the index is 1 if coordinate a of the corner is high[a], and 0 if
/// it is low[a].
std::vector<Vec3> box_corners(const Vec3& low, const Vec3& high);

}  // namespace beadswim
