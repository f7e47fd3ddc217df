#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "beadswim/coupling/bead_boundary.hpp"
#include "beadswim/coupling/bead_exchange.hpp"
#include "beadswim/coupling/bead_links.hpp"
#include "beadswim/coupling/close_beads.hpp"
#include "beadswim/coupling/conservation.hpp"
#include "beadswim/coupling/coverage.hpp"
#include "beadswim/coupling/fault.hpp"
#include "beadswim/coupling/saturated_cells.hpp"
#include "beadswim/coupling/saturated_sums.hpp"
#include "beadswim/coupling/scene.hpp"
#include "beadswim/coupling/swimmer_snapshot.hpp"
#include "beadswim/coupling/swimmer_state.hpp"
#include "beadswim/lattice/halo.hpp"
#include "beadswim/lattice/populations.hpp"
#include "beadswim/lattice/totals.hpp"
#include "beadswim/lattice/trt.hpp"

namespace beadswim {

/// What a checkpoint keeps of a system beside its populations and swimmers.
struct SystemMoment {
  long steps_done = 0;
  double largest_bead_speed = 0;  ///< so far
  double smallest_gap = 0;        ///< so far

  /// Visits the extremes so far.
  static void visit_fields(auto&& visit, auto& moment) {
    visit("largest_bead_speed", moment.largest_bead_speed);
    visit("smallest_gap", moment.smallest_gap);
  }
};

/// Fluid and swimmers on one lattice, advanced together. Lattice units throughout; all ranks of the
/// communicator construct it and call its functions together.
class CoupledSystem {
 public:
  /// Fluid and beads start at rest.
  CoupledSystem(const CoupledScene& scene, const Communicator& communicator);

  CoupledSystem(const CoupledSystem&) = delete;
  CoupledSystem& operator=(const CoupledSystem&) = delete;

  /// Advances everything by one step (coupled_step.cpp). If something becomes unphysical it goes on, so that
  /// no rank waits for another: swimmers at fault stay where they are, and a rank whose numbers are none any
  /// more leaves beads alone. fault() tells.
  void step();

  long steps_done() const { return steps_done_; }
  const CoupledScene& scene() const { return scene_; }
  const std::vector<SwimmerState>& owned_swimmers() const { return owned_; }
  const Populations& populations() const { return populations_; }
  const Decomposition& decomposition() const { return decomposition_; }
  const Coverage& coverage() const { return coverage_; }
  /// Beads that touch this rank's block; covered cells name them by their place in this list.
  const std::vector<BeadOnLattice>& beads_here() const { return beads_; }

  /// The first of what has gone wrong on any rank, if anything has; among it a bead whose surface moves by
  /// more than 1/2 cell a step (the paper's stop rule). Collective.
  std::optional<Fault> fault() const { return first_fault(fault_, communicator_); }

  /// Largest speed that any bead had at the end of any step [cell/step]. Collective.
  double largest_bead_speed() const;

  /// Smallest gap between two beads, or a bead and its own image, at the end of any step [cell]; infinite if
  /// none came within a cell. Collective.
  double smallest_gap() const;

  /// All swimmers in order of their id, on rank 0; empty elsewhere. Collective.
  std::vector<SwimmerState> gather_swimmers() const;

  /// All swimmers in order of their id with what is under way to them, on rank 0; empty elsewhere. With the
  /// populations' outgoing numbers and the moment it is all that the future depends on. Collective.
  std::vector<SwimmerSnapshot> gather_snapshots();

  /// What this rank has sent to others since the system was made.
  Traffic traffic() const;

  /// Other ranks that this one talks to.
  int neighbours() const;

  /// Collective.
  SystemMoment moment() const { return {steps_done_, largest_bead_speed(), smallest_gap()}; }

  /// Whether this rank moves a swimmer that is where the state says.
  bool owns(const SwimmerState& swimmer) const {
    return exchange_.owner_of(swimmer.motion[1].position) == communicator_.rank();
  }

  /// Goes on from a state of the same scene that was reached on any number of ranks. `swimmers`: at least
  /// those that this rank owns. `fill` sets outgoing numbers of all own cells of the block. Collective.
  void restore(const SystemMoment& moment, std::span<const SwimmerSnapshot> swimmers,
               const std::function<void(Populations&)>& fill);

  /// Collective. If the fluid is no longer finite what it returns means nothing, and fault() tells.
  SceneTotals totals();

 private:
  void step_fluid_with_links();
  void step_fluid_with_saturated_cells();
  void advance_swimmers(const std::map<BeadName, Impulse>& impulses);
  /// Where beads meet the fluid, and other swimmers' beads, for the coming step.
  void meet();
  void find_surfaces();
  void add_under_way(std::map<BeadName, Impulse>& impulses);
  /// What forbids a swimmer to move on; notes the largest speed.
  std::optional<Fault> fault_of(const SwimmerState& swimmer);
  void note(Fault fault);
  /// Calls a function that may throw on this rank alone, and notes what it throws.
  template <class Function>
  void noting_faults(Function&& function) {
    try {
      function();
    } catch (const FaultError& error) {
      note(error.fault);
      is_broken_ = true;
    } catch (const SolverError&) {
      note({.kind = FaultKind::not_finite});
      is_broken_ = true;
    }
  }
  /// The same, but where numbers are none any more it does not call it.
  template <class Function>
  void unless_broken(Function&& function) {
    if (!is_broken_) noting_faults(function);
  }
  /// This rank's parts of everything, and of all cells with beads moving in theirs.
  void add_totals(FluidTotals& everything, FluidTotals& all_cells) const;
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
  NearContactLaw near_contact_;
  std::vector<int> substeps_;  ///< of each type
  std::vector<SwimmerState> owned_;
  std::vector<BeadOnLattice> beads_, beads_before_;
  Coverage coverage_;
  BeadLinks links_;                            ///< empty in a scene of saturated cells
  SaturatedCells saturated_cells_;             ///< empty in a scene of links
  std::vector<LinkSums> link_sums_;            ///< of beads_, empty between steps
  std::vector<SaturatedSums> saturated_sums_;  ///< likewise
  std::map<BeadName, Impulse> under_way_;      ///< to owned swimmers, from before the state was restored
  std::optional<Fault> fault_;                 ///< the first that this rank came upon
  bool is_broken_ = false;                     ///< this rank's numbers are none any more
  double largest_bead_speed_ = 0;              ///< of owned swimmers
  double smallest_gap_;                        ///< of this block's close beads
  long steps_done_ = 0;
};

}  // namespace beadswim
