#include "beadswim/lattice/sweep.hpp"

#include "sweep_row.hpp"

namespace beadswim {
namespace {

struct Kernel {
  void (*sweep_row)(const SweepRow&);
  const char* instruction_set;
};

Kernel choose_kernel() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("x86-64-v4")) return {sweep_row_v4, "x86-64-v4"};
  if (__builtin_cpu_supports("x86-64-v3")) return {sweep_row_v3, "x86-64-v3"};
#endif
  return {sweep_row_baseline, "baseline"};
}

const Kernel& kernel() {
  static const Kernel chosen = choose_kernel();
  return chosen;
}

}  // namespace

void stream_and_collide(Populations& populations, const RelaxationRates& rates) {
  const Index3& n = populations.size();
  SweepRow row{.from = {}, .to = {}, .cells = n[0], .rates = rates};
  for (int z = 0; z < n[2]; ++z) {
    for (int y = 0; y < n[1]; ++y) {
      const std::ptrdiff_t first = populations.cell(0, y, z);
      for (int i = 0; i < d3q19::directions; ++i) {
        row.from[i] = &populations.incoming(i, first);
        row.to[i] = populations.next_outgoing(i, first);
      }
      kernel().sweep_row(row);
    }
  }
  populations.advance();
}

std::string sweep_instruction_set() {
  return kernel().instruction_set;
}

}  // namespace beadswim
