#include "models/warnings.hpp"

#include <fmt/core.h>

#include <cmath>

#include "beadswim/plan/velocity_roundoff.hpp"

namespace beadswim {
namespace {

using Lines = std::vector<std::string>;

void warn_of_resolution(Lines& lines, const SceneOnLattice& on_lattice) {
  if (on_lattice.resolution.cells_per_radius < 2) {
    lines.push_back(fmt::format("{:.3g} cells a radius do not resolve a bead; 3 or more do",
                                on_lattice.resolution.cells_per_radius));
  }
  constexpr double close = 2.5;
  if (on_lattice.smallest_gap < close) {
    lines.push_back(fmt::format(
        "beads, images or walls are {:.2g} cells apart at the start, too few to resolve the flow between: "
        "strokes may be wrong by some tens of per cent; take more --cells-per-radius, {:.2g} for {} cells",
        on_lattice.smallest_gap,
        std::ceil(on_lattice.resolution.cells_per_radius * close / on_lattice.smallest_gap), close));
  }
}

void warn_of_stability(Lines& lines, const SceneOnLattice& on_lattice) {
  if (on_lattice.density_on_lattice() < min_stable_density) {
    lines.push_back(fmt::format(
        "beads of {:.3g} times the fluid's density on the lattice; the coupling is explicit, and below {} it "
        "may become unstable; --delay-correction on helps, with it a larger --relaxation-time",
        on_lattice.density_on_lattice(), min_stable_density));
  }
  if (on_lattice.lattice.relaxation_time < min_stable_relaxation_time) {
    lines.push_back(fmt::format(
        "tau {:.4g} is so near 1/2 that the fluid hardly damps what cells do not resolve, and may become "
        "unstable, or turbulent where it should not; take {} or more",
        on_lattice.lattice.relaxation_time, min_stable_relaxation_time));
  }
  if (on_lattice.damps_springs) {
    lines.push_back(
        "springs vibrate faster than a step resolves, and get dashpots that damp that; slower motion lags in "
        "them by half a step at most");
  }
  if (on_lattice.angular_softening < 1) {
    lines.push_back(fmt::format(
        "swimmers vibrate in bending faster than steps follow; angular springs are softened, to {:.2g} of "
        "the layout's stiffness, and bend more by as little as loads do within a step; take a smaller step "
        "by a smaller --relaxation-time or more --cells-per-radius for less of it",
        on_lattice.angular_softening));
  }
}

void warn_of_roundoff(Lines& lines, Precision precision, double error) {
  if (error <= tolerated_roundoff) return;
  const std::string much = std::isfinite(error) ? fmt::format("{:.2g} of itself", error)
                                                : "more than itself, as to second order it is zero";
  if (precision == Precision::fp32) {
    lines.push_back(fmt::format(
        "in single precision the velocity may be wrong by {}: a swimmer is slow beside its beads, "
        "or the run long; take --precision double",
        much));
  } else {
    lines.push_back(
        fmt::format("a swimmer moves so little in a cycle that roundoff may change its velocity by {}: drive "
                    "it more, or leave its velocity to beadswim-theory",
                    much));
  }
}

}  // namespace

std::vector<std::string> warnings_before(const SceneOnLattice& on_lattice, double roundoff) {
  Lines lines;
  warn_of_resolution(lines, on_lattice);
  warn_of_stability(lines, on_lattice);
  warn_of_roundoff(lines, on_lattice.scene.precision, roundoff);
  return lines;
}

std::vector<std::string> warnings_after(double mach) {
  if (mach <= max_incompressible_mach) return {};
  return {fmt::format(
      "beads reached Mach {:.2g}, where the fluid's compressibility, some {:.0f} % there, changes what they "
      "do; take a smaller step by a smaller --relaxation-time or more --cells-per-radius",
      mach, 100 * mach * mach)};
}

}  // namespace beadswim
