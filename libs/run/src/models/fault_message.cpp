#include "models/fault_message.hpp"

#include <fmt/core.h>

#include "beadswim/core/setting.hpp"
#include "beadswim/coupling/bead_exchange.hpp"
#include "beadswim/coupling/close_beads.hpp"

namespace beadswim {
namespace {

std::string name_of(const BeadName& bead) {
  return fmt::format("bead {} of swimmer {}", bead.bead + 1, bead.swimmer);
}

/// Returns the place of a fault as text, in units of the layout: "bead 2 of swimmer 7 at (x, y, z)".
std::string place_of(const Fault& fault, const FaultyRun& run) {
  const Vec3 p = fault.position * run.length;
  return fmt::format("{} at ({:.6g}, {:.6g}, {:.6g})", name_of(fault.bead), p[0], p[1], p[2]);
}

std::string what_is_wrong(const Fault& fault, const FaultyRun& run) {
  const std::string place = place_of(fault, run);
  const std::string more_steps =
      fmt::format("increase {}, or reduce the driving amplitude", Setting::steps_per_cycle);
  switch (fault.kind) {
    case FaultKind::speed:
      return fmt::format(
          "the surface of {} moves {:.3g} cells per step, rotation included, above the limit of {} cells per "
          "step; {}",
          place, fault.value, speed_limit, run.cause);
    case FaultKind::displacement:
      return fmt::format("{} moves {:.3g} radii per step, above the limit of 1; {}{}", place, fault.value,
                         more_steps, run.other_model);
    case FaultKind::torn_arm:
      return fmt::format(
          "the arm from {} to bead {} is torn: its length is {:.3g} times the rest length, above the limit "
          "of {} times; use weaker driving or stiffer springs",
          place, fault.other.bead + 1, fault.value, max_stretch);
    case FaultKind::wall:
      return fmt::format(
          "{} is too close to a wall: the gap between bead and wall is {:.3g}, less than {:.3g}, half a "
          "cell; use a larger box or weaker driving",
          place, fault.value * run.length, min_wall_gap * run.length);
    case FaultKind::beyond_wall:
      return fmt::format(
          "{} lies {:.3g} beyond a wall; increase {}, reduce the driving amplitude, or enlarge the box",
          place, fault.value * run.length, Setting::steps_per_cycle);
    case FaultKind::in_wall:
      return fmt::format("{} overlaps the wall by {:.3g} radii; {}", place, fault.value, more_steps);
    case FaultKind::level:
      return fmt::format(
          "{} is too close to a coarser level of cells: the gap between them is {:.3g}, less than {:.3g}, {} "
          "cells, and the finest level cannot follow it, because no room is left or the bead is too fast; "
          "use a smaller {}, or {} off",
          place, fault.value * run.length, min_level_gap * run.length, min_level_gap, Setting::refinement,
          Setting::refinement);
    case FaultKind::overlap:
      return fmt::format(
          "{} and {} overlap by {:.3g} of the smaller radius, above the limit of {}; use weaker driving or "
          "stiffer springs",
          place, name_of(fault.other), fault.value, max_overlap);
    case FaultKind::not_finite:
      if (!run.mach)
        return fmt::format("the position of {} is non-finite; {}{}", place, more_steps, run.other_model);
      return fmt::format("the fluid{} has become unstable: its state is non-finite; {}",
                         fault.names_bead() ? " at " + place : "", run.cause);
    case FaultKind::mass:
      return fmt::format(
          "the total mass, which should be constant, has changed by a fraction {:.3g}: the fluid is becoming "
          "unstable; {}",
          fault.value, run.cause);
    case FaultKind::momentum:
      return fmt::format(
          "the total momentum of fluid and beads, which should be constant, has changed by {:.3g} times the "
          "momentum that all beads would have at the speed of the fastest bead; {}",
          fault.value, run.cause);
    case FaultKind::not_positive:
      return fmt::format(
          "the mobility is not positive definite any more: forces would move beads backwards, most of all "
          "{}, because beads are too close to each other or to a wall; use {} rpy",
          place, Setting::model);
    case FaultKind::not_converged:
      return fmt::format(
          "the solver for the velocities and forces of a step did not converge; {} or the damping{}",
          more_steps, run.other_model);
  }
  return "a fault of unknown kind was found; this is a fault of the program, please report it";
}

}  // namespace

EarlyStop model_fault(const Fault& fault, const FaultyRun& run) {
  const bool is_speed = fault.kind == FaultKind::speed || fault.kind == FaultKind::displacement;
  const std::string mach = run.mach ? fmt::format(", largest Mach number of a bead {:.2g}", *run.mach) : "";
  return {.status = is_speed ? RunStatus::stopped_speed : RunStatus::failed,
          .reason = fmt::format("step {} (cycle {:.3f}{}): {}", fault.step,
                                static_cast<double>(fault.step) / static_cast<double>(run.steps_per_cycle),
                                mach, what_is_wrong(fault, run))};
}

}  // namespace beadswim
