#pragma once

#include <vector>

#include "beadswim/core/vec3.hpp"
#include "svg.hpp"

namespace beadswim {

/// Central projection of a block, seen from its front, a little from the right and from above, such that it
/// fits into a part of the page.
///   page point = (d.right, -d.up) / (d.forward) scale + shift, d = point - eye
class Perspective {
 public:
  /// Of the block from `low` to `high` [length] into `width` x `height` px below and right of `top_left`, of
  /// which it takes what its shape allows.
  Perspective(const Vec3& low, const Vec3& high, svg::Point top_left, double width, double height);

  svg::Point at(const Vec3& point) const;
  double depth(const Vec3& point) const { return (point - eye_).dot(forward_); }  ///< [length]
  /// px of a length at the point's depth.
  double size_at(const Vec3& point, double length) const { return scale_ * length / depth(point); }
  double width() const { return width_; }    ///< that the block takes [px]
  double height() const { return height_; }  ///< [px]

 private:
  Vec3 eye_, right_, up_, forward_;
  double scale_ = 1;
  svg::Point shift_{};
  double width_ = 0, height_ = 0;
};

/// The box's corners: bit a of the index says whether it lies at the far end of axis a.
std::vector<Vec3> box_corners(const Vec3& low, const Vec3& high);

}  // namespace beadswim
