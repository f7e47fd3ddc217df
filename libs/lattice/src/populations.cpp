#include "beadswim/lattice/populations.hpp"

#include <sys/mman.h>

#include <cstring>
#include <new>

#include "beadswim/lattice/trt.hpp"

namespace beadswim {
namespace {

/// Numbers of a cache line, the width of the widest vectors: rows of own cells begin at a multiple of it.
constexpr std::ptrdiff_t line = 64 / sizeof(double);

std::ptrdiff_t whole_lines(std::ptrdiff_t count) {
  return (count + line - 1) / line * line;
}

/// Numbers in one direction's array. The 19 streams of a sweep advance together; arrays a multiple of 4 KiB
/// apart would compete for the same cache sets, so that each is placed some lines further on within a page.
std::ptrdiff_t staggered_pitch(std::ptrdiff_t count) {
  constexpr std::ptrdiff_t page = 4096 / sizeof(double), stagger = 5 * line;
  return (count + page - 1) / page * page + stagger;
}

double* zeros(std::size_t bytes) {
  constexpr std::size_t huge_page = std::size_t{1} << 21;
  const std::size_t whole = (bytes + huge_page - 1) / huge_page * huge_page;
  auto* memory = static_cast<double*>(std::aligned_alloc(huge_page, whole));
  if (memory == nullptr) throw std::bad_alloc();
  madvise(memory, whole, MADV_HUGEPAGE);  // a hint: 19 streams exhaust the table of small pages
  std::memset(memory, 0, whole);
  return memory;
}

}  // namespace

Populations::Populations(const Index3& size)
    : size_(size), pitch_y_(whole_lines(size[0] + 2)), pitch_z_(pitch_y_ * (size[1] + 2)) {
  // Outgoing populations of the halo's outermost cells lie up to a cell, row and plane outside the halo.
  const std::ptrdiff_t margin = whole_lines(pitch_y_ + 2);
  first_ = margin;
  cell_indices_ = pitch_z_ * (size[2] + 2) + 2 * margin;
  const std::ptrdiff_t pitch_i = staggered_pitch(cell_indices_);
  for (int i = 0; i < d3q19::directions; ++i) {
    const auto& c = d3q19::velocity[i];
    shift_[i] = c[0] + pitch_y_ * c[1] + pitch_z_ * c[2];
    place_[0][i] = d3q19::opposite(i) * pitch_i;
    place_[1][i] = i * pitch_i + shift_[i];
  }
  bytes_ = d3q19::directions * pitch_i * sizeof(double);
  data_.reset(zeros(bytes_));
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
