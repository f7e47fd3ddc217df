#pragma once

#include <optional>
#include <vector>

#include "beadswim/coupling/bead_boundary.hpp"
#include "beadswim/coupling/bead_exchange.hpp"
#include "beadswim/coupling/bead_links.hpp"
#include "beadswim/coupling/coverage.hpp"
#include "beadswim/coupling/saturated_cells.hpp"
#include "beadswim/coupling/saturated_sums.hpp"
#include "beadswim/coupling/scene.hpp"
#include "beadswim/coupling/swimmer_state.hpp"
#include "beadswim/lattice/halo.hpp"
#include "beadswim/lattice/populations.hpp"
#include "beadswim/lattice/totals.hpp"
#include "beadswim/lattice/trt.hpp"

namespace beadswim {

/// A bead faster than the limit: where a run must stop.
struct SpeedFault {
  long step = 0;
  BeadName bead;
  Vec3 position = Vec3::Zero();  ///< [cell]
  double speed = 0;              ///< [cell/step]
};

/// Sums over the whole scene, in lattice units.
struct SceneTotals {
  Vec3 momentum = Vec3::Zero();   ///< of fluid and beads, and of impulses under way between them
  Vec3 mean_flow = Vec3::Zero();  ///< volume mean of the velocity, covered cells moving with their bead
  /// Mass of the fluid, and of what beads hold of it, beyond density 1, relative to the mass of a box of
  /// fluid.
  double mass_excess = 0;
};

/// Fluid and swimmers on one lattice, advanced together. Lattice units throughout; all ranks of the
/// communicator construct it and call its functions together.
class CoupledSystem {
 public:
  /// Fluid and beads start at rest. Throws SolverError if beads overlap.
  CoupledSystem(const CoupledScene& scene, const Communicator& communicator);

  CoupledSystem(const CoupledSystem&) = delete;
  CoupledSystem& operator=(const CoupledSystem&) = delete;

  /// Advances everything by one step (coupled_step.cpp). Throws SolverError on this rank alone if something
  /// became unphysical; the caller must then stop all ranks.
  void step();

  long steps_done() const { return steps_done_; }
  const std::vector<SwimmerState>& owned_swimmers() const { return owned_; }
  const Populations& populations() const { return populations_; }
  const Decomposition& decomposition() const { return decomposition_; }
  const Coverage& coverage() const { return coverage_; }
  /// Beads that touch this rank's block; covered cells name them by their place in this list.
  const std::vector<BeadOnLattice>& beads_here() const { return beads_; }

  /// The earliest bead of any rank that went faster than 1/2 cell a step, if any (the paper's stop rule: a
  /// bead must not cross half a cell in a step). Collective.
  std::optional<SpeedFault> speed_fault() const;

  /// Largest speed that any bead had at the end of any step [cell/step]. Collective.
  double largest_bead_speed() const;

  /// All swimmers in order of their id, on rank 0; empty elsewhere. Collective.
  std::vector<SwimmerState> gather_swimmers() const;

  /// Collective. Throws SolverError if the fluid is no longer finite.
  SceneTotals totals() const;

 private:
  void step_fluid_with_links();
  void step_fluid_with_saturated_cells();
  void advance_swimmers(const std::map<BeadName, Impulse>& impulses);
  /// Whether a bead is over the speed limit; notes the first that is, and the largest speed.
  bool is_too_fast(const SwimmerState& swimmer);
  /// Takes what covered cells have, which is no fluid, out of the fluid's totals; returns their momentum when
  /// they move with their beads.
  FluidTotals exchange_covered_cells(FluidTotals& fluid) const;
  /// Takes what fluid within owned swimmers' beads has out of the totals; returns the momentum of the beads'
  /// volumes when they move with their beads.
  FluidTotals exchange_inner_fluid(FluidTotals& fluid) const;

  const Communicator& communicator_;
  CoupledScene scene_;
  RelaxationRates rates_;
  Decomposition decomposition_;
  Populations populations_;
  Halo halo_;
  BeadExchange exchange_;
  std::vector<int> substeps_;  ///< of each type
  std::vector<SwimmerState> owned_;
  std::vector<BeadOnLattice> beads_, beads_before_;
  Coverage coverage_;
  BeadLinks links_;                            ///< empty in a scene of saturated cells
  SaturatedCells saturated_cells_;             ///< empty in a scene of links
  std::vector<LinkSums> link_sums_;            ///< of beads_, empty between steps
  std::vector<SaturatedSums> saturated_sums_;  ///< likewise
  std::optional<SpeedFault> speed_fault_;
  double largest_bead_speed_ = 0;  ///< of owned swimmers
  long steps_done_ = 0;
};

}  // namespace beadswim
