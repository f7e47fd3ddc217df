#include "models/fault_message.hpp"

#include <fmt/core.h>

#include <cmath>

#include "beadswim/coupling/bead_exchange.hpp"
#include "beadswim/coupling/close_beads.hpp"

namespace beadswim {
namespace {

std::string name_of(const BeadName& bead) {
  return fmt::format("bead {} of swimmer {}", bead.bead + 1, bead.swimmer);
}

/// Returns the place of a fault as text, in units of the layout: "bead 2 of swimmer 7 at (x, y, z)".
std::string place_of(const Fault& fault, const UnitScales& scales) {
  const Vec3 p = fault.position * scales.length;
  return fmt::format("{} at ({:.6g}, {:.6g}, {:.6g})", name_of(fault.bead), p[0], p[1], p[2]);
}

/// Returns the likely cause of an instability, with a remedy. An instability is a non-finite state, or a bead
/// that is too fast. `mach_so_far`: largest Mach number of a bead before the fault.
std::string cause_of_instability(const SceneOnLattice& on_lattice, double mach_so_far) {
  const double density = on_lattice.density_on_lattice(), tau = on_lattice.lattice.relaxation_time;
  if (density < min_stable_density) {
    return fmt::format(
        "the beads' density on the lattice, {:.3g} times the fluid's density, is too low for the explicit "
        "coupling of beads and fluid; use {}{} psm, or a larger {}",
        density, on_lattice.corrects_delay ? "" : fmt::format("{} on, ", Setting::delay_correction),
        Setting::bead_boundary, Setting::relaxation_time);
  }
  if (tau < min_stable_relaxation_time) {
    return fmt::format(
        "the relaxation time {:.4g} is so close to 1/2 that viscosity hardly damps unresolved flow; use a "
        "larger {} or {}",
        tau, Setting::relaxation_time, Setting::cells_per_radius);
  }
  const std::string smaller_step = fmt::format("reduce the time step by a smaller {} or a larger {}",
                                               Setting::relaxation_time, Setting::cells_per_radius);
  if (mach_so_far > max_incompressible_mach)
    return fmt::format(
        "the fastest bead has reached Mach {:.2g} (Mach 1: speed of sound of the lattice); reduce the "
        "driving amplitude, or {}",
        mach_so_far, smaller_step);
  return fmt::format("reduce the driving amplitude, or {}", smaller_step);
}

std::string what_is_wrong(const Fault& fault, const SceneOnLattice& on_lattice, double mach_so_far) {
  const UnitScales& scales = on_lattice.lattice.scales;
  switch (fault.kind) {
    case FaultKind::speed:
      return fmt::format(
          "the surface of {} moves {:.3g} cells per step, rotation included, above the limit of {} cells per "
          "step; {}",
          place_of(fault, scales), fault.value, speed_limit, cause_of_instability(on_lattice, mach_so_far));
    case FaultKind::torn_arm:
      return fmt::format(
          "the arm from {} to bead {} is torn: its length is {:.3g} times the rest length, above the limit "
          "of {} times; use weaker driving or stiffer springs",
          place_of(fault, scales), fault.other.bead + 1, fault.value, max_stretch);
    case FaultKind::wall:
      return fmt::format(
          "{} is too close to a wall: the gap between bead and wall is {:.3g}, less than {:.3g}, half a "
          "cell; use a larger box or weaker driving",
          place_of(fault, scales), fault.value * scales.length, min_wall_gap * scales.length);
    case FaultKind::level:
      return fmt::format(
          "{} is too close to a coarser level of cells: the gap between them is {:.3g}, less than {:.3g}, {} "
          "cells, and the finest level cannot follow it, because no room is left or the bead is too fast; "
          "use a smaller {}, or {} off",
          place_of(fault, scales), fault.value * scales.length, min_level_gap * scales.length, min_level_gap,
          Setting::refinement, Setting::refinement);
    case FaultKind::overlap:
      return fmt::format(
          "{} and {} overlap by {:.3g} of the smaller radius, above the limit of {}; use weaker driving or "
          "stiffer springs",
          place_of(fault, scales), name_of(fault.other), fault.value, max_overlap);
    case FaultKind::not_finite:
      return fmt::format("the fluid{} has become unstable: its state is non-finite; {}",
                         fault.names_bead() ? " at " + place_of(fault, scales) : "",
                         cause_of_instability(on_lattice, mach_so_far));
    case FaultKind::mass:
      return fmt::format(
          "the total mass, which should be constant, has changed by a fraction {:.3g}: the fluid is becoming "
          "unstable; {}",
          fault.value, cause_of_instability(on_lattice, mach_so_far));
    case FaultKind::momentum:
      return fmt::format(
          "the total momentum of fluid and beads, which should be constant, has changed by {:.3g} times the "
          "momentum that all beads would have at the speed of the fastest bead; {}",
          fault.value,
          on_lattice.scene.precision == Precision::fp32 ? fmt::format("use {} double", Setting::precision)
                                                        : cause_of_instability(on_lattice, mach_so_far));
  }
  return "a fault of unknown kind was found; this is a fault of the program, please report it";
}

}  // namespace

std::string fault_message(const Fault& fault, const SceneOnLattice& on_lattice, double mach_so_far) {
  const double steps = static_cast<double>(on_lattice.lattice.steps_per_period);
  const double mach = fault.kind == FaultKind::speed ? fault.value * std::sqrt(3.0) : mach_so_far;
  return fmt::format("step {} (cycle {:.3f}, largest Mach number of a bead {:.2g}): {}", fault.step,
                     static_cast<double>(fault.step) / steps, mach,
                     what_is_wrong(fault, on_lattice, mach_so_far));
}

}  // namespace beadswim
