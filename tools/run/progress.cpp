#include "progress.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "beadswim/core/error.hpp"
#include "beadswim/coupling/refinement.hpp"

namespace beadswim {
namespace {

ProgressStyle resolve_style(ProgressStyle style) {
  if (style != ProgressStyle::automatic) return style;
  return isatty(STDERR_FILENO) != 0 ? ProgressStyle::bar : ProgressStyle::lines;
}

double seconds(std::chrono::steady_clock::duration interval) {
  return std::chrono::duration<double>(interval).count();
}

std::string duration_text(double seconds) {
  const long s = std::lround(seconds);
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{} min {:02} s", s / 60, s % 60);
  return fmt::format("{} h {:02} min", s / 3600, s % 3600 / 60);
}

}  // namespace

Progress::Progress(ProgressStyle style, const ModelPlan& plan)
    : style_(resolve_style(style)), plan_(plan), start_(Clock::now()), last_(start_) {}

void Progress::update(long steps_done) {
  const double interval = style_ == ProgressStyle::bar ? 0.2 : 10;
  if (style_ == ProgressStyle::none || seconds(Clock::now() - last_) < interval) return;
  last_ = Clock::now();
  print(steps_done);
}

void Progress::finish(long steps_done) {
  if (style_ == ProgressStyle::none) return;
  print(steps_done);
  if (style_ == ProgressStyle::bar) print_to_stderr("\n");
}

void Progress::print(long steps_done) {
  const auto done = static_cast<double>(steps_done), first = static_cast<double>(plan_.steps_done),
             steps = static_cast<double>(plan_.steps_in(plan_.settings.cycles)),
             cycle = static_cast<double>(plan_.steps_per_cycle);
  const SceneOnLattice* const lattice = plan_.lattice();
  const double updates = lattice ? updates_per_step(lattice->scene.all_levels()) : 0;
  const double elapsed = seconds(Clock::now() - start_);
  const double now_done = done - first;
  const double left = now_done > 0 ? elapsed * (steps - done) / now_done : 0;
  const double mlups = elapsed > 0 ? 1e-6 * updates * now_done / elapsed : 0;
  if (style_ == ProgressStyle::json) {
    print_to_stderr(fmt::format("{{\"step\":{},\"steps\":{},\"cycle\":{:.4f},{}\"seconds_left\":{:.1f}}}\n",
                                steps_done, steps, done / cycle,
                                lattice ? fmt::format("\"mlups\":{:.3f},", mlups) : "", left));
    return;
  }
  const std::string line = fmt::format(
      "cycle {:.2f} of {:.2f}, {:3.0f} %,{} {} left", done / cycle, steps / cycle, 100 * done / steps,
      lattice ? fmt::format(" {:.1f} MLUPS,", mlups) : "", duration_text(left));
  if (style_ == ProgressStyle::lines) {
    print_to_stderr(fmt::format("beadswim-run: {}\n", line));
    return;
  }
  constexpr int width = 30;
  const std::string filled(static_cast<std::size_t>(width * done / steps), '#');
  print_to_stderr(fmt::format("\r[{:<{}}] {}\x1b[K", filled, width, line));
}

}  // namespace beadswim
