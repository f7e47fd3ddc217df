#include "beadswim/lattice/fluid_step.hpp"

#include <algorithm>

#include "beadswim/core/kernel.hpp"
#include "row_kernels.hpp"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace beadswim {
namespace {

/// Rounds subnormal numbers to zero during the lifetime of the object, because processors evaluate them much
/// more slowly than other numbers. In single precision they occur while the first waves spread into fluid at
/// rest: ahead of these waves, populations decrease by an order of magnitude per cell.
struct FlushSubnormals {
#if defined(__SSE2__)
  FlushSubnormals() {
    constexpr unsigned flush_to_zero = 0x8000, subnormals_are_zero = 0x0040;
    _mm_setcsr(before | flush_to_zero | subnormals_are_zero);
  }
  ~FlushSubnormals() {
    _mm_setcsr(before);
  }
  const unsigned before = _mm_getcsr();
#endif
};

/// Sweeps the rows of a block, in any order. Before a row is swept, all incoming populations of its cells
/// must be set: by boundary conditions where they come from walls and beads, and by the halo where they come
/// from outside the block.
template <class Real>
class BlockSweep {
 public:
  BlockSweep(const Populations& populations, RowEnds row_ends, std::span<const Block> skipped,
             const SweepRow<Real>& row)
      : populations_(populations), row_ends_(row_ends), skipped_(skipped), row_(row) {}

  void row(int y, int z) {
    [[maybe_unused]] const FlushSubnormals flush{};
    const int cells = populations_.size()[0];
    for_each_run_outside(skipped_, cells, y, z, [&](int first, int end) {
      row_.first = populations_.cell(first, y, z);
      row_.cells = end - first;
      if (row_.cells < std::min(cells, max_short_run) && y + 2 < populations_.size()[1])
        prefetch(populations_.cell(first, y + 2, z));
      best_kernels<RowKernels>().sweep(row_);
    });
    row_.first = populations_.cell(0, y, z);
    row_.cells = cells;
    fill_row_ends();
  }

 private:
  static constexpr int max_short_run = 16;  ///< [cell]

  /// Begins to load the populations of a short run of cells that begins at cell `first`, as long as the
  /// present one. The processor itself foresees only the addresses of long runs.
  void prefetch(std::ptrdiff_t first) const {
    for (const Real* from : row_.incoming) {
      __builtin_prefetch(from + first, 1);
      __builtin_prefetch(from + first + row_.cells - 1, 1);
    }
  }

  /// Fills the halo cells at both ends of the row that has just been swept.
  void fill_row_ends() const {
    if (row_ends_ == RowEnds::left_to_halo) return;
    const std::ptrdiff_t first = row_.first, last = row_.first + row_.cells - 1;
#pragma GCC unroll 19
    for (int i = 1; i < d3q19::directions; ++i) {
      const int sign = d3q19::velocity[i][0];
      if (sign == 0) continue;
      const std::ptrdiff_t halo = sign > 0 ? first - 1 : last + 1;
      if (row_ends_ == RowEnds::wrapped) row_.outgoing(i)[halo] = row_.outgoing(i)[sign > 0 ? last : first];
      if (row_ends_ == RowEnds::mirrored)
        row_.outgoing(i)[halo] = row_.outgoing(d3q19::mirrored(i, 0))[sign > 0 ? first : last];
    }
  }

  const Populations& populations_;
  RowEnds row_ends_;
  std::span<const Block> skipped_;
  SweepRow<Real> row_;  ///< `first` and `cells` change from row to row
};

/// Calls work(sweep of the block in the precision of its populations), then completes the step.
template <class Work>
void sweep_block(Populations& populations, const RelaxationRates& rates, RowEnds row_ends,
                 const Vec3& body_force, std::span<const Block> skipped, Work&& work) {
  in_precision(populations.precision(), [&]<class Real>() {
    SweepRow<Real> row;
    row.rates = collision_rates<Real>(rates);
    row.force.acts = body_force != Vec3::Zero();
    for (int a = 0; a < 3; ++a) row.force.twelfth[a] = static_cast<Real>(body_force[a] / 12);
    for (int i = 0; i < d3q19::directions; ++i) row.incoming[i] = populations.incoming_row<Real>(i, 0);
    BlockSweep<Real> sweep(populations, row_ends, skipped, row);
    work(sweep);
  });
  populations.advance(row_ends);
}

}  // namespace

void step_fluid(Populations& populations, Halo& halo, const RelaxationRates& rates, const Vec3& body_force,
                const StepCallbacks& callbacks, std::span<const Block> skipped) {
  halo.start(populations);
  const int rows = populations.size()[1], planes = populations.size()[2];
  sweep_block(populations, rates, halo.row_ends(), body_force, skipped, [&](auto& sweep) {
    for (int n = 0; n < planes; ++n) {
      if (n < first_outer_plane(planes)) halo.progress();
      if (n == first_outer_plane(planes)) halo.finish(populations);
      const int z = plane_in_order(n, planes);
      if (callbacks.before_plane) callbacks.before_plane(z);
      for (int y = 0; y < rows; ++y) {
        if (callbacks.before_row) callbacks.before_row(y, z);
        sweep.row(y, z);
      }
      if (callbacks.after_plane) callbacks.after_plane(z);
    }
  });
}

void stream_and_collide(Populations& populations, const RelaxationRates& rates, RowEnds row_ends,
                        const Vec3& body_force) {
  sweep_block(populations, rates, row_ends, body_force, {}, [&](auto& sweep) {
    for (int z = 0; z < populations.size()[2]; ++z) {
      for (int y = 0; y < populations.size()[1]; ++y) sweep.row(y, z);
    }
  });
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
