#include "beadswim/lattice/populations.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <new>

#include "beadswim/lattice/trt.hpp"

namespace beadswim {
namespace {

/// Doubles in one direction's array. The 38 streams of a sweep advance together; arrays a multiple of 4 KiB
/// apart would compete for the same cache sets, so that each is placed 192 bytes further on within a page.
std::ptrdiff_t staggered_pitch(std::ptrdiff_t cells) {
  constexpr std::ptrdiff_t page = 512, stagger = 24;
  return (cells + page - 1) / page * page + stagger;
}

}  // namespace

Populations::Array Populations::zeros(std::ptrdiff_t count) {
  constexpr std::size_t huge_page = std::size_t{1} << 21;
  const std::size_t bytes = (count * sizeof(double) + huge_page - 1) / huge_page * huge_page;
  auto* memory = static_cast<double*>(std::aligned_alloc(huge_page, bytes));
  if (memory == nullptr) throw std::bad_alloc();
  madvise(memory, bytes, MADV_HUGEPAGE);  // a hint: 38 streams exhaust the table of small pages
  std::fill_n(memory, count, 0.0);
  return Array(memory);
}

Populations::Populations(const Index3& size)
    : size_(size),
      pitch_y_(size[0] + 2),
      pitch_z_(pitch_y_ * (size[1] + 2)),
      pitch_i_(staggered_pitch(pitch_z_ * (size[2] + 2))),
      now_(zeros(pitch_i_ * d3q19::directions)),
      next_(zeros(pitch_i_ * d3q19::directions)) {
  for (int i = 0; i < d3q19::directions; ++i) {
    const auto& c = d3q19::velocity[i];
    shift_[i] = c[0] + pitch_y_ * c[1] + pitch_z_ * c[2];
  }
}

CellMoments cell_moments(const Populations& populations, std::ptrdiff_t cell) {
  CellMoments moments;
  for (int i = 0; i < d3q19::directions; ++i) {
    const double f = populations.outgoing(i, cell);
    const auto& c = d3q19::velocity[i];
    moments.density_deviation += f;
    moments.momentum += f * Vec3(c[0], c[1], c[2]);
  }
  return moments;
}

void set_equilibrium(Populations& populations, std::ptrdiff_t cell, double r, const Vec3& u) {
  for (int i = 0; i < d3q19::directions; ++i) {
    populations.outgoing(i, cell) = equilibrium(i, r, u[0], u[1], u[2]);
  }
}

}  // namespace beadswim
