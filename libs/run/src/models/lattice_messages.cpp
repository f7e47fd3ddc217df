#include <fmt/core.h>

#include <cmath>

#include "beadswim/core/setting.hpp"
#include "models/lattice_model.hpp"

namespace beadswim {
namespace {

/// Returns the likely cause of an instability, with a remedy. An instability is a non-finite state, or a bead
/// that is too fast. `mach_so_far`: largest Mach number of a bead before the fault.
std::string cause_of_instability(const SceneOnLattice& on_lattice, double mach_so_far) {
  const double density = on_lattice.density_on_lattice(), tau = on_lattice.lattice.relaxation_time;
  if (density < min_stable_density) {
    return fmt::format(
        "the beads' density on the lattice, {:.3g} times the fluid's density, is too low for the explicit "
        "coupling of beads and fluid; use {}{} psm, or a larger {}",
        density, on_lattice.scene.corrects_delay ? "" : fmt::format("{} on, ", Setting::delay_correction),
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

void warn_of_resolution(std::vector<RunWarning>& warnings, const SceneOnLattice& on_lattice) {
  const double cells_per_radius = on_lattice.resolution.cells_per_radius, gap = on_lattice.smallest_gap;
  if (cells_per_radius < 2) {
    add_warning(warnings, "beads-unresolved", "{:.3g} cells per radius do not resolve a bead; use 3 or more",
                cells_per_radius);
  }
  constexpr double close = 2.5;
  if (gap < close) {
    add_warning(
        warnings, "gaps-unresolved",
        "the smallest gap between beads, images or walls is {:.2g} cells at the start, too few to resolve "
        "the flow: strokes may be wrong by tens of per cent; use {} {:.2g} for a gap of {} cells",
        gap, Setting::cells_per_radius, std::ceil(cells_per_radius * close / gap), close);
  }
}

void warn_of_stability(std::vector<RunWarning>& warnings, const SceneOnLattice& on_lattice) {
  if (on_lattice.density_on_lattice() < min_stable_density) {
    add_warning(warnings, "light-beads",
                "the beads' density on the lattice is {:.3g} times the fluid's density; below {} times, the "
                "explicit coupling may become unstable; use {} on, together with a larger {}",
                on_lattice.density_on_lattice(), min_stable_density, Setting::delay_correction,
                Setting::relaxation_time);
  }
  if (on_lattice.lattice.relaxation_time < min_stable_relaxation_time) {
    add_warning(warnings, "relaxation-time",
                "the relaxation time {:.4g} is so close to 1/2 that viscosity hardly damps unresolved flow: "
                "the fluid may become unstable or show unphysical turbulence; use {} or more",
                on_lattice.lattice.relaxation_time, min_stable_relaxation_time);
  }
  if (on_lattice.damps_springs) {
    add_warning(warnings, "springs-damped",
                "springs vibrate too fast for the time step, so dashpots are added that damp these "
                "vibrations; these dashpots delay slower motion by at most half a time step");
  }
  if (on_lattice.angular_softening() < 1) {
    add_warning(
        warnings, "angular-springs-softened",
        "bending vibrations are too fast for the time step, so angular springs are softened to {:.2g} of the "
        "layout's stiffness; to soften them less, reduce the time step by a smaller {} or a larger {}",
        on_lattice.angular_softening(), Setting::relaxation_time, Setting::cells_per_radius);
  }
}

void warn_of_roundoff(std::vector<RunWarning>& warnings, Precision precision, double error) {
  if (constexpr double tolerated = 0.002; error <= tolerated) return;
  const std::string much =
      std::isfinite(error)
          ? fmt::format("{:.2g}", error)
          : "more than 1, because the velocity is zero to second order in the driving amplitude";
  if (precision == Precision::fp32) {
    add_warning(warnings, "roundoff",
                "in single precision the relative error of a swimmer's velocity may be {}: roundoff is too "
                "large if a swimmer is slow compared with its beads, or if the run is long; use {} double",
                much, Setting::precision);
  } else {
    add_warning(warnings, "roundoff",
                "a swimmer moves so little per cycle that roundoff may cause a relative error of its "
                "velocity of {}; increase the driving amplitude, or use the velocity of beadswim-theory",
                much);
  }
}

}  // namespace

FaultyRun faulty_run(const Fault& fault, const SceneOnLattice& on_lattice, double mach_so_far) {
  const bool is_roundoff = fault.kind == FaultKind::momentum && on_lattice.scene.precision == Precision::fp32;
  return {.length = on_lattice.lattice.scales.length,
          .steps_per_cycle = on_lattice.lattice.steps_per_period,
          .mach = fault.kind == FaultKind::speed ? fault.value * std::sqrt(3.0) : mach_so_far,
          .cause = is_roundoff ? fmt::format("use {} double", Setting::precision)
                               : cause_of_instability(on_lattice, mach_so_far),
          .other_model = {}};
}

std::vector<RunWarning> warnings_before(const SceneOnLattice& on_lattice, double roundoff) {
  std::vector<RunWarning> warnings;
  warn_of_resolution(warnings, on_lattice);
  warn_of_stability(warnings, on_lattice);
  warn_of_roundoff(warnings, on_lattice.scene.precision, roundoff);
  return warnings;
}

std::vector<RunWarning> warnings_after(double mach) {
  std::vector<RunWarning> warnings;
  if (mach > max_incompressible_mach) {
    add_warning(warnings, "compressible",
                "the fastest bead reached Mach {:.2g} (Mach 1: speed of sound of the lattice), where "
                "compression changes the density of the fluid by about {:.0f} % and affects the motion; "
                "reduce the time step by a smaller {} or a larger {}",
                mach, 100 * mach * mach, Setting::relaxation_time, Setting::cells_per_radius);
  }
  return warnings;
}

}  // namespace beadswim
