#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/figure/flow_picture.hpp"
#include "beadswim/io/vti.hpp"

// Flow files, of which a figure shows one plane.

namespace beadswim {

/// Plane of a figure, as --plane gives it.
struct FlowPlane {
  std::optional<int> across{};         ///< axis across the plane: 0, 1, 2 for x, y, z
  std::optional<double> coordinate{};  ///< place of the plane along this axis [length]
};

/// Flow files of one time, from coarse to fine.
class FlowField {
 public:
  explicit FlowField(const std::vector<std::string>& paths);

  const Eigen::AlignedBox3d& extent() const { return extent_; }
  /// Returns the cells of the coarsest file, which also say whether the flow is a mean, and its frame.
  const VtiCells& cells() const { return files_.front().cells(); }

  /// Returns the plane with both values set: by default across z, or across the axis along which the field
  /// has only one layer of cells, in the middle of the field. Throws InputError if the plane is not in the
  /// field.
  FlowPlane resolved(const FlowPlane& wanted) const;

  /// Returns the flow in a resolved plane, interpolated between the layers of cells on both sides of it.
  /// Throws InputError if a file is damaged.
  std::vector<FlowLayer> layers(const FlowPlane& plane) const;

 private:
  std::vector<VtiReader> files_;
  std::string source_;
  Eigen::AlignedBox3d extent_;
};

}  // namespace beadswim
