#pragma once

#include <optional>
#include <vector>

#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/mobility/ewald_plan.hpp"
#include "ewald_split.hpp"
#include "imaged_spheres.hpp"
#include "mobility_kernels.hpp"

namespace beadswim {

/// Returns the near part of the mobility tensor of two spheres of radii a_i and a_j at the distance r, which
/// complements the mesh. For overlapping spheres it contains the difference between the tensor of overlapping
/// spheres and the formula for spheres that do not overlap, which the mesh uses for all pairs. `split`:
/// nullopt: returns the whole tensor. `is_positive`: EwaldPlan::is_positive.
PairTensor near_part(const std::optional<EwaldSplit>& split, bool is_positive, double a_i, double a_j,
                     double r, double viscosity);

/// Table of near_part() for forces without moments.
class TensorTable {
 public:
  /// Pairs closer than `min_distance`, a bead diameter, are evaluated without the table [length].
  TensorTable(const ImagedSpheres& spheres, const EwaldPlan& plan, double min_distance);
  TensorTable(const TensorTable&) = delete;
  TensorTable& operator=(const TensorTable&) = delete;

  /// Returns the squared distance up to which pairs are not in the table.
  double min_square() const { return min_square_; }
  const PairTable& table() const { return table_; }

 private:
  double min_square_;
  PairTable table_;
  std::vector<double> coefficients_;
};

}  // namespace beadswim
