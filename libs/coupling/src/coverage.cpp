#include "beadswim/coupling/coverage.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

/// The cells of row (y, z) whose centres lie inside the bead: a sphere meets a row in one run.
CoveredRun covered_run(const CoveredImage& covered, double radius, int y, int z) {
  const double radius_squared = radius * radius;
  const auto is_inside = [&](int x) { return covered.from_centre(x, y, z).squaredNorm() < radius_squared; };
  CoveredRun run{.low = covered.image.low[0], .high = covered.image.high[0]};
  while (run.low < run.high && !is_inside(run.low)) ++run.low;
  while (run.low < run.high && !is_inside(run.high - 1)) --run.high;
  return run;
}

[[noreturn]] void throw_overlap(const BeadOnLattice& a, const BeadOnLattice& b) {
  const Vec3& at = b.motion.position;
  throw SolverError(
      fmt::format("bead {} of swimmer {} and bead {} of swimmer {} overlap at ({:.2f}, {:.2f}, {:.2f}) "
                  "cells; weaker driving or stiffer springs keep them apart",
                  a.name.bead + 1, a.name.swimmer, b.name.bead + 1, b.name.swimmer, at[0], at[1], at[2]));
}

}  // namespace

Coverage::Coverage(const BlockInLattice& at, const Populations& populations)
    : at_(at),
      pitch_y_(populations.pitch(1)),
      pitch_z_(populations.pitch(2)),
      origin_(populations.cell(0, 0, 0)),
      state_((at.block.size + 2 * margin).cast<std::ptrdiff_t>().prod(), State::fluid) {}

bool Coverage::is_fluid(const Index3& cell) const {
  Index3 inside = cell;
  for (int axis = 0; axis < 3; ++axis) {
    if (at_.periodic[axis]) continue;
    const int place = cell[axis] + at_.block.offset[axis], end = at_.cells[axis];
    if (place >= 0 && place < end) continue;
    if (at_.no_slip[axis]) return false;
    inside[axis] = (place < 0 ? -1 - place : 2 * end - 1 - place) - at_.block.offset[axis];
  }
  return !is_covered(inside[0], inside[1], inside[2]);
}

bool Coverage::is_near_wall(const BeadImage& image, int distance) const {
  for (int axis = 0; axis < 3; ++axis) {
    const int low = image.low[axis] + at_.block.offset[axis],
              high = image.high[axis] + at_.block.offset[axis];
    if (!at_.periodic[axis] && (low < distance || high > at_.cells[axis] - distance)) return true;
  }
  return false;
}

void Coverage::update(std::span<const BeadOnLattice> beads) {
  std::swap(before_, now_);
  before_.for_each_run([&](const CoveredImage&, const CoveredRun& run, int y, int z) {
    const auto first = state_.begin() + place_of_state(run.low, y, z);
    std::fill_n(first, run.high - run.low, State::just_left);
  });
  now_.images.clear();
  now_.runs.clear();
  newly_covered_.clear();
  for (int b = 0; b < std::ssize(beads); ++b) {
    for_each_image(at_, margin, beads[b].motion.position, beads[b].radius,
                   [&](const BeadImage& image) { cover(beads, b, image); });
  }
  uncovered_.clear();
  before_.for_each_run([&](const CoveredImage& covered, const CoveredRun& run, int y, int z) {
    for (int x = run.low; x < run.high; ++x) {
      State& now = state(x, y, z);
      if (now != State::just_left) continue;
      now = State::fluid;
      if (is_own(x, y, z)) uncovered_.push_back(changed_cell(covered, x, y, z));
    }
  });
}

void Coverage::cover(std::span<const BeadOnLattice> beads, int bead, const BeadImage& image) {
  const CoveredImage& covered =
      now_.images.emplace_back(CoveredImage{.image = image,
                                            .index = static_cast<int>(now_.images.size()),
                                            .bead = bead,
                                            .centre = beads[bead].motion.position,
                                            .first_run = static_cast<int>(now_.runs.size())});
  for (int z = image.low[2]; z < image.high[2]; ++z) {
    for (int y = image.low[1]; y < image.high[1]; ++y) {
      now_.runs.push_back(covered_run(covered, beads[bead].radius, y, z));
    }
  }
  for (int z = image.low[2]; z < image.high[2]; ++z) {
    for (int y = image.low[1]; y < image.high[1]; ++y) {
      cover_run(beads, covered, now_.run(covered, y, z), y, z);
    }
  }
}

void Coverage::cover_run(std::span<const BeadOnLattice> beads, const CoveredImage& covered,
                         const CoveredRun& run, int y, int z) {
  for (int x = run.low; x < run.high; ++x) {
    State& now = state(x, y, z);
    if (now == State::covered) throw_overlap(beads[first_bead_at(x, y, z)], beads[covered.bead]);
    if (now == State::fluid && is_own(x, y, z)) newly_covered_.push_back(changed_cell(covered, x, y, z));
    now = State::covered;
  }
}

int Coverage::first_bead_at(int x, int y, int z) const {
  int bead = -1;
  now_.for_each_run([&](const CoveredImage& covered, const CoveredRun& run, int run_y, int run_z) {
    const bool contains = run_y == y && run_z == z && run.low <= x && x < run.high;
    if (bead < 0 && contains) bead = covered.bead;
  });
  return bead;
}

}  // namespace beadswim
