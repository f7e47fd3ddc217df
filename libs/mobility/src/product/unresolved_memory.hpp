#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "beadswim/mobility/fluid_memory.hpp"

namespace beadswim {

// clang-format off
/// Memory of the fluid at wavenumbers above the cutoff k_c of the mesh, in the flow of the force of each sphere at
/// itself; higher moments have none there. mu is the part of the self-mobility (moment_self_mobility) above the cutoff. Of
/// its flow, only the part mu_h follows the forces in a step; the rest decays as one mode (fluid_memory.hpp):
///
///   mu_h = s mu s,   s = sqrt(1 - phi) for forces, 1 for other moments
///   1/rate = integral_kc^oo j_0(ka)^2/(nu k^2) dk / integral_kc^oo j_0(ka)^2 dk
///
/// This rate gives the velocity of a force the exact delay at low frequency. mu_h is positive definite.
// clang-format on
class UnresolvedMemory {
 public:
  /// `order`: highest moment of the forces.
  UnresolvedMemory(std::span<const double> radii, int order, double viscosity, const FluidMemory& fluid,
                   double cutoff);

  /// Adds the flow by this memory (fluid_memory.hpp) to the projections on the moments of all spheres.
  void add_projections(std::span<const double> moments, FlowPart part, std::span<double> projections) const;
  void start(std::span<const double> moments);
  void end_step(std::span<const double> moments);

  /// g, projections of the flow that earlier forces leave at the end of the next step.
  const std::vector<double>& state() const { return remaining_flow_; }
  void restore(std::vector<double> state) { remaining_flow_ = std::move(state); }

 private:
  struct Sphere {
    Eigen::MatrixXd delayed_mobility;  ///< mu - mu_h
    StepFactors step;                  ///< factors of the mode in a time step
  };
  /// Sets g = share of g + factor (mu - mu_h) moments, for the factors of each sphere.
  template <class Share, class Factor>
  void update(const Share& share, const Factor& factor, std::span<const double> moments);

  std::vector<std::shared_ptr<const Sphere>> spheres_;  ///< spheres of equal radius share one
  std::size_t count_;                                   ///< moments of a sphere
  std::vector<double> remaining_flow_;
};

}  // namespace beadswim
