#include "beadswim/lattice/sweep.hpp"

#include <algorithm>
#include <variant>

#include "beadswim/core/kernel_choice.hpp"
#include "flush_subnormals.hpp"
#include "row_kernels.hpp"

namespace beadswim {
namespace {

template <class Real>
BodyForce<Real> in_kernel_form(const Vec3& body_force) {
  BodyForce<Real> force;
  for (int a = 0; a < 3; ++a) force.twelfth[a] = static_cast<Real>(body_force[a] / 12);
  force.acts = body_force != Vec3::Zero();
  return force;
}

constexpr int max_short_run = 16;  ///< [cell]

/// Begins to load the populations of a short run of cells that begins at cell `first`, as long as `row`. The
/// processor itself foresees only the addresses of long runs.
template <class Real>
void prefetch(const SweepRow<Real>& row, std::ptrdiff_t first) {
  for (const Real* from : row.incoming) {
    __builtin_prefetch(from + first, 1);
    __builtin_prefetch(from + first + row.cells - 1, 1);
  }
}

/// Fills the halo cells at both ends of a row that has just been swept.
template <class Real>
void fill_row_ends(const SweepRow<Real>& row, RowEnds row_ends) {
  if (row_ends == RowEnds::left_to_halo) return;
  const std::ptrdiff_t first = row.first, last = row.first + row.cells - 1;
#pragma GCC unroll 19
  for (int i = 1; i < d3q19::directions; ++i) {
    const int sign = d3q19::velocity[i][0];
    if (sign == 0) continue;
    const std::ptrdiff_t halo = sign > 0 ? first - 1 : last + 1;
    if (row_ends == RowEnds::wrapped) row.outgoing(i)[halo] = row.outgoing(i)[sign > 0 ? last : first];
    if (row_ends == RowEnds::mirrored)
      row.outgoing(i)[halo] = row.outgoing(d3q19::mirrored(i, 0))[sign > 0 ? first : last];
  }
}

}  // namespace

/// Arguments of the kernel that sweeps one row, in the precision of the populations. Only `first` and `cells`
/// change from row to row.
struct BlockSweep::Rows {
  std::variant<SweepRow<double>, SweepRow<float>> row;
};

BlockSweep::BlockSweep(Populations& populations, const RelaxationRates& rates, RowEnds row_ends,
                       const Vec3& body_force, std::span<const Block> skipped)
    : populations_(populations), row_ends_(row_ends), skipped_(skipped), rows_(std::make_unique<Rows>()) {
  in_precision(populations.precision(), [&]<class Real>() {
    SweepRow<Real> row;
    row.rates = collision_rates<Real>(rates);
    row.force = in_kernel_form<Real>(body_force);
    for (int i = 0; i < d3q19::directions; ++i) row.incoming[i] = populations.incoming_row<Real>(i, 0);
    rows_->row = row;
  });
}

BlockSweep::~BlockSweep() = default;

void BlockSweep::row(int y, int z) {
  const FlushSubnormals flush;
  in_precision(populations_.precision(), [&]<class Real>() { row_as<Real>(y, z); });
}

template <class Real>
void BlockSweep::row_as(int y, int z) {
  auto& row = std::get<SweepRow<Real>>(rows_->row);
  const int cells = populations_.size()[0];
  for_each_run_outside(skipped_, cells, y, z, [&](int first, int end) {
    row.first = populations_.cell(first, y, z);
    row.cells = end - first;
    if (row.cells < std::min(cells, max_short_run) && y + 2 < populations_.size()[1])
      prefetch(row, populations_.cell(first, y + 2, z));
    best_kernels<RowKernels>().sweep(row);
  });
  row.first = populations_.cell(0, y, z);
  row.cells = cells;
  fill_row_ends(row, row_ends_);
}

void BlockSweep::finish() {
  populations_.advance(row_ends_);
}

void stream_and_collide(Populations& populations, const RelaxationRates& rates, RowEnds row_ends,
                        const Vec3& body_force) {
  BlockSweep sweep(populations, rates, row_ends, body_force);
  for (int z = 0; z < populations.size()[2]; ++z) {
    for (int y = 0; y < populations.size()[1]; ++y) sweep.row(y, z);
  }
  sweep.finish();
}

Vec3 acting_body_force(const Vec3& body_force, Precision precision) {
  constexpr int digits = 10;
  if (precision == Precision::fp64) return body_force;
  return (body_force / 12).unaryExpr([](double g) { return 12 * with_digits(g, digits); });
}

std::string sweep_instruction_set() {
  return best_kernels<RowKernels>().instruction_set;
}

}  // namespace beadswim
