#pragma once

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "beadswim/core/fields.hpp"
#include "beadswim/coupling/bead_exchange.hpp"
#include "beadswim/coupling/bead_links.hpp"
#include "beadswim/coupling/close_beads.hpp"
#include "beadswim/coupling/coverage.hpp"
#include "beadswim/coupling/fault.hpp"
#include "beadswim/coupling/saturated_cells.hpp"
#include "beadswim/coupling/scene.hpp"
#include "beadswim/coupling/swimmer_state.hpp"
#include "beadswim/lattice/levels.hpp"
#include "beadswim/lattice/totals.hpp"

namespace beadswim {

/// Part of the state of a system that a checkpoint stores in addition to populations and swimmers.
struct SystemProgress {
  long steps_done = 0;
  double largest_bead_speed = 0;  ///< largest speed of any bead so far [cell/step]
  /// Smallest gap so far, as CoupledSystem::smallest_gap() [cell].
  double smallest_gap = std::numeric_limits<double>::infinity();
  Vec3 body_force = Vec3::Zero();  ///< momentum that each cell gains in the next step
  /// Impulse of net driving forces that no body force has balanced yet.
  Vec3 unbalanced = Vec3::Zero();
  std::vector<BodyImpulse> body_impulses{};  ///< Levels::body_impulses()

  /// Visits all fields but the number of steps.
  BEADSWIM_FIELDS(largest_bead_speed, smallest_gap, body_force, unbalanced, body_impulses)
};

/// Momentum, mean flow and mass of the complete scene, summed over all ranks, in lattice units.
struct SceneTotals {
  Vec3 momentum = Vec3::Zero();  ///< momentum of fluid, beads and impulses not yet applied to the beads
  /// Mean velocity over the volume of the box. Cells within a bead count with the velocity of the bead.
  Vec3 mean_flow = Vec3::Zero();
  /// Sum of (density - 1) over the fluid cells, plus the fluid mass that the beads have taken up and not yet
  /// returned; divided by the number of cells.
  double mass_excess = 0;

  BEADSWIM_FIELDS(momentum, mean_flow, mass_excess)
};

/// Fluid and swimmers on one lattice, advanced together, in lattice units. All ranks of the communicator
/// construct the system together. They must call its collective functions and step() together.
class CoupledSystem {
 public:
  /// Fluid and beads start at rest.
  CoupledSystem(const CoupledScene& scene, const Communicator& communicator);

  CoupledSystem(const CoupledSystem&) = delete;
  CoupledSystem& operator=(const CoupledSystem&) = delete;

  /// Advances fluid and swimmers by one step (coupled_step.cpp). A fault (an unphysical state, fault.hpp)
  /// does not interrupt the step, because other ranks would wait for messages without end. Instead, a swimmer
  /// with a fault keeps its position, and a rank whose state has become non-finite stops updating its beads.
  /// Call fault() after the step to learn of faults. Collective.
  void step();

  long steps_done() const { return progress_.steps_done; }
  const CoupledScene& scene() const { return scene_; }
  const std::vector<SwimmerState>& owned_swimmers() const { return owned_; }
  const Levels& levels() const { return levels_; }
  Levels& levels() { return levels_; }
  const Coverage& coverage() const { return coverage_; }
  /// Returns the beads that touch the block of this rank. coverage() identifies the bead of a covered cell by
  /// its index in this list.
  const std::vector<BeadOnLattice>& beads_here() const { return beads_; }

  /// Returns the forces of beads on the fluid in the last step of this system (psm;
  /// SaturatedCells::forces()).
  const std::vector<SaturatedForce>& saturated_forces() const { return saturated_cells_.forces(); }

  /// Returns the first fault on any rank, or nothing if no rank has found a fault. For example, a bead has a
  /// fault if its surface moves by more than 1/2 cell per step (the stop rule of Pickl et al. 2017).
  /// Collective.
  std::optional<Fault> fault() const { return first_fault(fault_, communicator_); }

  /// Returns the largest speed of any bead at the end of any step [cell/step]. Collective.
  double largest_bead_speed() const;

  /// Returns the smallest gap between two beads, or between a bead and its own periodic image, at the end of
  /// any step [cell]. Returns infinity if no gap was smaller than one cell. Collective.
  double smallest_gap() const;

  /// Returns all swimmers in order of their id on rank 0, and an empty list on other ranks. Collective.
  std::vector<SwimmerState> gather_swimmers() const;

  /// Returns the complete states of all swimmers in order of their id on rank 0, and an empty list on other
  /// ranks. The states include pending impulses: impulses that the beads have received in the last step but
  /// that are not yet applied. These snapshots, the outgoing populations and progress() determine all later
  /// steps. Collective.
  std::vector<SwimmerSnapshot> gather_snapshots();

  /// Returns the messages that this rank has sent since the construction of the system.
  Traffic traffic() const;

  /// Returns the number of other ranks that this rank communicates with.
  int neighbours() const;

  /// Returns the progress of the run. Collective.
  SystemProgress progress() const {
    SystemProgress progress = progress_;
    progress.largest_bead_speed = largest_bead_speed();
    progress.smallest_gap = smallest_gap();
    progress.body_impulses = levels_.body_impulses();
    return progress;
  }

  /// Returns true if this rank owns the swimmer, that is if its middle() lies in the block of this rank.
  bool owns(const SwimmerState& swimmer) const {
    return exchange_.owner_of(swimmer.middle()) == communicator_.rank();
  }

  /// Restores a state of the same scene. The state may have been computed on any number of ranks. `swimmers`
  /// must include all swimmers that this rank owns. `fill` must set the outgoing populations of all cells of
  /// this rank on all levels. Collective.
  void restore(const SystemProgress& progress, std::span<const SwimmerSnapshot> swimmers,
               const std::function<void(Levels&)>& fill);

  /// Returns the totals of the scene. The totals are meaningless if the state of any rank is non-finite;
  /// fault() reports this. Collective.
  SceneTotals totals();

 private:
  bool has_links() const { return beadswim::has_links(scene_.bead_boundary); }
  void advance_fluid();
  void advance_swimmers(const std::map<BeadName, Impulse>& impulses);
  void add_driving_impulse(const SwimmerMotion& now, const SwimmerMotion& before, const SwimmerLoads& loads,
                           const SwimmerType& type);
  void add_dipole(SwimmerState& swimmer, const SwimmerMotion& before, const SwimmerLoads& reactions,
                  const Eigen::Matrix3d& stress) const;
  /// Sets the body force of the next step, in scenes with net driving forces that no wall takes up. Along the
  /// periodic axes, it balances the driving forces of this step and removes a part of the momentum that fluid
  /// and beads have with the densities of the layout. Collective: such scenes alone communicate globally in
  /// each step.
  void balance_net_force();
  /// Adds the body force on the cells that each bead covers to its impulse.
  void add_body_force_on_beads();
  /// Prepares the next step: finds the links or the saturated cells, and adds the impulses between close
  /// beads of different swimmers.
  void find_links_and_contacts();
  void find_links_or_saturated_cells();
  void add_pending_impulses(std::map<BeadName, Impulse>& impulses);
  /// Returns the fault of a swimmer, if it has one. Also updates the largest speed and the smallest gap.
  std::optional<Fault> fault_of(const SwimmerState& swimmer);
  void record_fault(Fault fault);
  /// Calls visit(swimmer, index of the bead, bead of its type) for all beads of owned swimmers.
  void for_each_owned_bead(auto&& visit) const {
    for (const SwimmerState& swimmer : owned_) {
      const std::vector<BeadAtRest>& beads = scene_.types[swimmer.type].beads;
      for (std::size_t b = 0; b < beads.size(); ++b) visit(swimmer, b, beads[b]);
    }
  }
  /// Calls `function`, which may throw on this rank while it succeeds on other ranks. Records an exception as
  /// a fault of this rank instead of passing it on, because the other ranks continue the step. The state of
  /// this rank then counts as non-finite.
  template <class Function>
  void record_faults(Function&& function) {
    try {
      function();
    } catch (const FaultError& error) {
      record_fault(error.fault);
      state_is_finite_ = false;
    } catch (const SolverError&) {
      record_fault({.kind = FaultKind::not_finite});
      state_is_finite_ = false;
    }
  }
  /// Calls record_faults(function), but does nothing if the state of this rank is non-finite.
  template <class Function>
  void if_state_is_finite(Function&& function) {
    if (state_is_finite_) record_faults(function);
  }
  // Totals of mass and momentum, contributions of this rank:
  /// Fluid of the finest level outside beads.
  FluidTotals fluid_totals() const;
  /// Beads, and impulses that are not yet applied to beads.
  FluidTotals bead_totals() const;
  /// Volume within beads, at density 1 and the velocity of the bead, plus half of the last impulse of the
  /// body force, which Levels::half_impulse() contains for this volume too. With psm, less half of the forces
  /// on the fluid outside the beads, which does not belong to its velocity.
  FluidTotals volume_of_beads() const;
  /// Mass of a bead beyond that of the displaced fluid, with the density of the layout.
  double excess_mass(const Bead& bead) const;
  /// Momentum of owned beads beyond volume_of_beads(), with the densities of the layout.
  FluidTotals excess_totals() const;

  const Communicator& communicator_;
  CoupledScene scene_;
  Levels levels_;
  BeadExchange exchange_;
  NearContactLaw near_contact_;
  bool has_net_force_ = false;   ///< true if a body force balances net driving forces
  FluidTotals driving_impulse_;  ///< impulse of driving forces on owned swimmers in this step
  std::vector<int> substeps_;    ///< number of substeps per step, for each swimmer type
  std::vector<SwimmerState> owned_;
  std::vector<BeadOnLattice> beads_, beads_before_;
  Coverage coverage_;
  BeadLinks links_;                 ///< empty for psm
  SaturatedCells saturated_cells_;  ///< empty for schemes with links
  /// Impulses on owned swimmers that a restored state contained and that are not yet applied.
  std::map<BeadName, Impulse> pending_impulses_;
  std::optional<Fault> fault_;   ///< the first fault on this rank
  bool state_is_finite_ = true;  ///< false after a number on this rank became non-finite
  /// Speed and gap are those of this rank: of owned swimmers, and of close beads in its block. body_impulses
  /// is not up to date.
  SystemProgress progress_;
};

/// Returns a fault if mass or momentum has changed by more than roundoff can explain since the totals
/// `first`, or if one of them is non-finite in the totals `now`. The mass is conserved. The momentum is
/// conserved in a box that is periodic along all axes. The change of momentum is divided by the momentum of
/// all beads at `bead_speed`, the largest speed of any bead so far [cell/step]. Fault::step is not set.
///
/// The limits in totals.cpp are far larger than roundoff. Six cycles of the swimmer of Pickl et al.
/// 2017 at 2 cells per radius, in double precision, changed the momentum by 2e-15 of the momentum of the
/// beads at their largest speed. The mass did not change. In single precision the changes were 4e-7 for
/// momentum and, relative to the mass of the fluid, 2e-11 for mass.
std::optional<Fault> conservation_fault(const CoupledScene& scene, const SceneTotals& first,
                                        const SceneTotals& now, double bead_speed);

/// Gathers one plane of a level on rank 0: `components` doubles per cell, in the order component (slowest),
/// y, x (fastest). `z` counts from the first plane of the level. Each rank calls value(component, cell) for
/// the cells of its block; cells under a finer level get 0. Returns an empty vector on other ranks.
/// Collective.
std::vector<double> gather_plane(const Level& level, const Communicator& communicator, int z, int components,
                                 const std::function<double(int component, std::ptrdiff_t cell)>& value);

/// Returns the SHA-256 hash of the populations of all levels, in the order of gather_plane(), and of the
/// states of all beads, in the order of the ids of their swimmers. The hash does not depend on the number of
/// ranks. Returns an empty string on ranks other than 0. Collective.
std::string state_sha256(const CoupledSystem& system, const Communicator& communicator);

}  // namespace beadswim
