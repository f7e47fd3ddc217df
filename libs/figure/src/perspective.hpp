#pragma once

#include <algorithm>

#include "beadswim/core/vec3.hpp"
#include "svg.hpp"

namespace beadswim {

/// A rectangular block [length], or an area of the page [px].
using Block = Eigen::AlignedBox3d;
using PageArea = Eigen::AlignedBox2d;

/// Central projection of a rectangular block onto a part of the page. The eye is in front of the block, a
/// little to the right and above. With the vector d = point - eye and the scalar product ".",
///   page point = (d.right, -d.up) / (d.forward) scale + shift
/// right, up and forward are the unit vectors of the directions of view.
class Perspective {
 public:
  /// Projects the block into a rectangle of `width` x `height` px whose top left corner is `top_left`. The
  /// projection keeps its proportions and may not fill the rectangle.
  Perspective(const Block& block, svg::Point top_left, double width, double height)
      : eye_(block.center() + eye_distance * block.diagonal().norm() * -forward_) {
    PageArea area;
    for (int corner = 0; corner < 8; ++corner) area.extend(project(block.corner(Block::CornerType(corner))));
    scale_ = std::min(width / area.sizes().x(), height / area.sizes().y());
    shift_ = top_left - scale_ * area.min();
    size_ = scale_ * area.sizes();
  }

  /// Returns the projection of a point onto the page.
  svg::Point project(const Vec3& point) const {
    const Vec3 d = point - eye_;
    return shift_ + scale_ / d.dot(forward_) * svg::Point(d.dot(right_), -d.dot(up_));
  }
  double depth(const Vec3& point) const { return (point - eye_).dot(forward_); }  ///< from the eye [length]
  /// Returns the projected size [px] of a length that has the depth of the point.
  double projected_size(const Vec3& point, double length) const { return scale_ * length / depth(point); }
  const svg::Point& size() const { return size_; }  ///< width and height of the projected block [px]

 private:
  static constexpr double eye_distance = 3.2;  // from the centre, relative to the diagonal

  const Vec3 forward_ = -Vec3(0.42, -0.84, 0.34).normalized();
  const Vec3 right_ = Vec3::UnitZ().cross(-forward_).normalized(), up_ = (-forward_).cross(right_);
  const Vec3 eye_;
  double scale_ = 1;
  svg::Point shift_ = svg::Point::Zero(), size_ = svg::Point::Zero();
};

}  // namespace beadswim
