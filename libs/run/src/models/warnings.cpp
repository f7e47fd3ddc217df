#include "models/warnings.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <utility>

#include "beadswim/run/velocity_roundoff.hpp"

namespace beadswim {
namespace {

/// A list of warnings that grows by add().
struct Warnings {
  std::vector<RunWarning> list;

  void add(const char* code, std::string message) { list.push_back({code, std::move(message)}); }
};

void warn_of_resolution(Warnings& warnings, const SceneOnLattice& on_lattice) {
  const double cells_per_radius = on_lattice.resolution.cells_per_radius, gap = on_lattice.smallest_gap;
  if (cells_per_radius < 2) {
    warnings.add(
        "beads-unresolved",
        fmt::format("{:.3g} cells per radius do not resolve a bead; use 3 or more", cells_per_radius));
  }
  constexpr double close = 2.5;
  if (gap < close) {
    warnings.add(
        "gaps-unresolved",
        fmt::format(
            "the smallest gap between beads, images or walls is {:.2g} cells at the start, too few to "
            "resolve the flow: strokes may be wrong by tens of per cent; use {} {:.2g} "
            "for a gap of {} cells",
            gap, Setting::cells_per_radius, std::ceil(cells_per_radius * close / gap), close));
  }
}

void warn_of_stability(Warnings& warnings, const SceneOnLattice& on_lattice) {
  if (on_lattice.density_on_lattice() < min_stable_density) {
    warnings.add(
        "light-beads",
        fmt::format("the beads' density on the lattice is {:.3g} times the fluid's density; below {} "
                    "times, the explicit coupling may become unstable; use {} on, together with a larger {}",
                    on_lattice.density_on_lattice(), min_stable_density, Setting::delay_correction,
                    Setting::relaxation_time));
  }
  if (on_lattice.lattice.relaxation_time < min_stable_relaxation_time) {
    warnings.add(
        "relaxation-time",
        fmt::format("the relaxation time {:.4g} is so close to 1/2 that viscosity hardly damps "
                    "unresolved flow: the fluid may become unstable or show unphysical turbulence; use "
                    "{} or more",
                    on_lattice.lattice.relaxation_time, min_stable_relaxation_time));
  }
  if (on_lattice.damps_springs) {
    warnings.add(
        "springs-damped",
        "springs vibrate too fast for the time step, so dashpots are added that damp these vibrations; "
        "these dashpots delay slower motion by at most half a time step");
  }
  if (on_lattice.angular_softening() < 1) {
    warnings.add(
        "angular-springs-softened",
        fmt::format("bending vibrations are too fast for the time step, so angular springs are softened "
                    "to {:.2g} of the layout's stiffness; to soften them less, reduce the time step by "
                    "a smaller {} or a larger {}",
                    on_lattice.angular_softening(), Setting::relaxation_time, Setting::cells_per_radius));
  }
}

void warn_of_roundoff(Warnings& warnings, Precision precision, double error) {
  if (error <= tolerated_roundoff) return;
  const std::string much =
      std::isfinite(error)
          ? fmt::format("{:.2g}", error)
          : "more than 1, because the velocity is zero to second order in the driving amplitude";
  if (precision == Precision::fp32) {
    warnings.add(
        "roundoff",
        fmt::format("in single precision the relative error of a swimmer's velocity may be {}: roundoff "
                    "is too large if a swimmer is slow compared with its beads, or if the run is long; "
                    "use {} double",
                    much, Setting::precision));
  } else {
    warnings.add(
        "roundoff",
        fmt::format("a swimmer moves so little per cycle that roundoff may cause a relative error of "
                    "its velocity of {}; increase the driving amplitude, or use the velocity of "
                    "beadswim-theory",
                    much));
  }
}

}  // namespace

std::vector<RunWarning> warnings_before(const SceneOnLattice& on_lattice, double roundoff) {
  Warnings warnings;
  warn_of_resolution(warnings, on_lattice);
  warn_of_stability(warnings, on_lattice);
  warn_of_roundoff(warnings, on_lattice.scene.precision, roundoff);
  return warnings.list;
}

std::vector<RunWarning> warnings_after(double mach) {
  Warnings warnings;
  if (mach > max_incompressible_mach) {
    warnings.add(
        "compressible",
        fmt::format("the fastest bead reached Mach {:.2g} (Mach 1: speed of sound of the lattice), "
                    "where compression changes the density of the fluid by about {:.0f} % and affects "
                    "the motion; reduce the time step by a smaller {} or a larger {}",
                    mach, 100 * mach * mach, Setting::relaxation_time, Setting::cells_per_radius));
  }
  return warnings.list;
}

}  // namespace beadswim
