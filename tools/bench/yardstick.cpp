#include "yardstick.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "beadswim/core/huge_pages.hpp"
#include "beadswim/core/kernel.hpp"
#include "beadswim/core/round_up.hpp"
#include "stream_kernels.hpp"

namespace beadswim {
namespace {

/// Returns the number of elements from the first to the last of all arrays.
std::ptrdiff_t num_elements(const StreamLayout& layout, int edge) {
  return (d3q19::directions - 1) * layout.array + (edge - 1) * (layout.row + layout.plane) + edge;
}

/// Returns the memory layouts that the class StreamYardstick tries for a cube of edge^3 cells: the layout of
/// the solver; contiguous arrays; arrays that start at different offsets within a memory page; arrays
/// interleaved row by row.
std::vector<StreamLayout> stream_layouts(int edge, Precision precision) {
  // Elements per cache line (64 bytes) and per page (4096 bytes).
  const auto line = static_cast<std::ptrdiff_t>(64 / bytes_per_population(precision)), page = 64 * line;
  const std::ptrdiff_t edge_with_halo = edge + 2, padded_edge = round_up_to_multiple(edge, line);
  const std::ptrdiff_t cube = padded_edge * edge * edge,
                       cube_with_halo = edge_with_halo * edge_with_halo * edge_with_halo;
  return {{"solver", round_up_to_multiple(cube_with_halo, page) + 5 * line, edge_with_halo,
           edge_with_halo * edge_with_halo},
          {"plain", cube, padded_edge, padded_edge * edge},
          {"staggered", round_up_to_multiple(cube, page) + 5 * line, padded_edge, padded_edge * edge},
          {"interleaved-rows", padded_edge, d3q19::directions * padded_edge,
           d3q19::directions * padded_edge * edge}};
}

}  // namespace

Bandwidth::Bandwidth()
    : source_(static_cast<double*>(allocate_zeros_on_huge_pages(num_elements * sizeof(double)))),
      destination_(static_cast<double*>(allocate_zeros_on_huge_pages(num_elements * sizeof(double)))) {
  for (long k = 0; k < num_elements; ++k)
    source_[k] = 1 + k % 997;  // numbers that are not zero, as in the yardstick
}

void Bandwidth::copy() {
  best_kernels<StreamKernels>().copy(source_.get(), destination_.get(), num_elements);
}

void Bandwidth::scale_in_place() {
  best_kernels<StreamKernels>().scale_in_place(source_.get(), num_elements, 0.999);
}

StreamYardstick::StreamYardstick(int edge, Precision precision)
    : edge_(edge), precision_(precision), layout_(stream_layouts(edge, precision).front()) {
  std::ptrdiff_t max_elements = 0;
  for (const StreamLayout& layout : stream_layouts(edge, precision))
    max_elements = std::max(max_elements, num_elements(layout, edge));
  memory_.reset(allocate_zeros_on_huge_pages(max_elements * bytes_per_population(precision)));
  // Some processors move zeros faster than other numbers: by a quarter on an AMD EPYC of family 26.
  in_precision(precision, [&]<class Real>() {
    Real* const numbers = static_cast<Real*>(memory_.get());
    for (std::ptrdiff_t k = 0; k < max_elements; ++k) numbers[k] = static_cast<Real>(1e-3 * (1 + k % 997));
  });
}

void StreamYardstick::choose_layout(int rounds, const Communicator& communicator) {
  StreamLayout best = layout_;
  double shortest = std::numeric_limits<double>::infinity();
  for (const StreamLayout& layout : stream_layouts(edge_, precision_)) {
    layout_ = layout;
    sweep();
    for (int round = 0; round < rounds; ++round) {
      MPI_Barrier(communicator.get());
      const double start = MPI_Wtime();
      sweep();
      sweep();
      double seconds = MPI_Wtime() - start;
      MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_MAX, communicator.get());
      if (seconds < shortest) {
        shortest = seconds;
        best = layout;
      }
    }
  }
  layout_ = best;
}

void StreamYardstick::sweep() {
  in_precision(precision_, [&]<class Real>() {
    const StreamKernels& kernels = best_kernels<StreamKernels>();
    StreamRow<Real> row{.rows = {}, .cells = edge_};
    for (int z = 0; z < edge_; ++z) {
      for (int y = 0; y < edge_; ++y) {
        Real* first = static_cast<Real*>(memory_.get()) + y * layout_.row + z * layout_.plane;
        for (int i = 0; i < d3q19::directions; ++i) row.rows[i] = first + i * layout_.array;
        kernels.stream_row(row);
      }
    }
  });
}

}  // namespace beadswim
