#include "perspective.hpp"

#include <algorithm>

namespace beadswim {
namespace {

const Vec3 to_the_eye = Vec3(0.42, -0.84, 0.34).normalized();  // direction from the block centre to the eye
constexpr double eye_distance = 3.2;                           // from the centre, relative to the diagonal

}  // namespace

std::vector<Vec3> box_corners(const Vec3& low, const Vec3& high) {
  std::vector<Vec3> corners;
  for (int corner = 0; corner < 8; ++corner) {
    corners.push_back({(corner & 1) != 0 ? high.x() : low.x(), (corner & 2) != 0 ? high.y() : low.y(),
                       (corner & 4) != 0 ? high.z() : low.z()});
  }
  return corners;
}

Perspective::Perspective(const Vec3& low, const Vec3& high, svg::Point top_left, double width, double height)
    : eye_((low + high) / 2 + eye_distance * (high - low).norm() * to_the_eye),
      right_(Vec3::UnitZ().cross(to_the_eye).normalized()),
      up_(to_the_eye.cross(right_)),
      forward_(-to_the_eye) {
  svg::Point first = project((low + high) / 2), last = first;
  for (const Vec3& corner : box_corners(low, high)) {
    const svg::Point point = project(corner);
    first = {std::min(first.x, point.x), std::min(first.y, point.y)};
    last = {std::max(last.x, point.x), std::max(last.y, point.y)};
  }
  scale_ = std::min(width / (last.x - first.x), height / (last.y - first.y));
  shift_ = {top_left.x - scale_ * first.x, top_left.y - scale_ * first.y};
  width_ = scale_ * (last.x - first.x);
  height_ = scale_ * (last.y - first.y);
}

svg::Point Perspective::project(const Vec3& point) const {
  const Vec3 d = point - eye_;
  const double shrink = scale_ / d.dot(forward_);
  return {shift_.x + shrink * d.dot(right_), shift_.y - shrink * d.dot(up_)};
}

}  // namespace beadswim
