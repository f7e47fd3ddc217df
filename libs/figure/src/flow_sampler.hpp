#pragma once

#include <algorithm>
#include <span>

#include "beadswim/figure/flow_picture.hpp"

namespace beadswim {

/// Interpolates between the cells of several layers.
class FlowSampler {
 public:
  explicit FlowSampler(std::span<const FlowLayer> layers) : layers_(layers) {
    for (const FlowLayer& layer : layers_) region_.extend(layer.extent());
  }

  const Eigen::AlignedBox2d& region() const { return region_; }

  /// Return linear interpolations between the four cells around a place. A place outside of the region has
  /// the values of the nearest place in it.
  Vec3 velocity(const PlanePoint& place) const {
    return interpolated<Vec3>(place, Vec3::Zero(),
                              [](const FlowLayer& layer, std::size_t n) { return layer.velocity[n]; });
  }
  double covered(const PlanePoint& place) const {
    return interpolated<double>(place, 0, [](const FlowLayer& layer, std::size_t n) {
      return layer.covered.empty() ? 0 : layer.covered[n];
    });
  }

 private:
  /// Returns the number of the cell that contains a place in the extent of the layer.
  static std::size_t cell_at(const FlowLayer& layer, const PlanePoint& place) {
    const Eigen::Array2i cell = ((place - layer.origin) / layer.spacing).array().floor().cast<int>();
    const Eigen::Array2i inside = cell.max(0).min(layer.cells - 1);
    return layer.index(inside.x(), inside.y());
  }

  template <class Value, class ValueOf>
  Value interpolated(const PlanePoint& anywhere, const Value& zero, const ValueOf& value_of) const {
    const PlanePoint place = anywhere.cwiseMax(region_.min()).cwiseMin(region_.max());
    const auto shows = [&](const FlowLayer& layer) {
      return layer.extent().contains(place) && !layer.is_hidden(cell_at(layer, place));
    };
    const auto found = std::find_if(layers_.rbegin(), layers_.rend(), shows);
    if (found == layers_.rend()) return zero;
    const FlowLayer& layer = *found;
    const PlanePoint at = (place - layer.origin) / layer.spacing - PlanePoint(0.5, 0.5);
    const Eigen::Array2i low = at.array().floor().cast<int>();
    Value sum = zero;
    double weights = 0;  // hidden cells have none
    for (int corner = 0; corner < 4; ++corner) {
      const Eigen::Array2i cell = low + Eigen::Array2i(corner % 2, corner / 2);
      const Eigen::Array2i inside = cell.max(0).min(layer.cells - 1);
      const std::size_t index = layer.index(inside.x(), inside.y());
      if (layer.is_hidden(index)) continue;
      const double weight = (1 - (at.array() - cell.cast<double>()).abs()).prod();
      sum += weight * value_of(layer, index);
      weights += weight;
    }
    return sum / weights;
  }

  std::span<const FlowLayer> layers_;
  Eigen::AlignedBox2d region_;
};

}  // namespace beadswim
