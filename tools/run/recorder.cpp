#include "recorder.hpp"

#include <algorithm>
#include <cmath>

namespace beadswim {

Recorder::Recorder(const SceneOnLattice& on_lattice, int frames_per_cycle, TrajectoryWriter& trajectory)
    : scales_(on_lattice.lattice.scales),
      period_(on_lattice.period),
      steps_per_cycle_(on_lattice.lattice.steps_per_period),
      frames_per_cycle_(static_cast<int>(std::min<long>(frames_per_cycle, steps_per_cycle_))),
      trajectory_(trajectory) {
  for (const CoupledScene::Swimmer& swimmer : on_lattice.scene.swimmers) {
    swimmers_.push_back({.id = swimmer.id, .cycles = {}});
  }
  std::ranges::sort(swimmers_, {}, &SwimmerRecord::id);
  samples_.resize(swimmers_.size());
}

long Recorder::step_of_frame(long frame) const {
  return std::lround(static_cast<double>(frame) / frames_per_cycle_ * static_cast<double>(steps_per_cycle_));
}

void Recorder::record(const CoupledSystem& system, const SceneTotals& totals) {
  const std::vector<SwimmerState> swimmers = system.gather_swimmers();

  TrajectoryFrame frame{.step = system.steps_done(),
                        .time = static_cast<double>(system.steps_done()) * scales_.step,
                        .positions = {},
                        .velocities = {},
                        .mean_flow = totals.mean_flow * scales_.velocity(),
                        .momentum = totals.momentum * scales_.momentum()};
  for (const SwimmerState& swimmer : swimmers) {
    for (const BeadMotion& bead : swimmer.motion) {
      frame.positions.push_back(bead.position * scales_.cell);
      frame.velocities.push_back(bead.velocity * scales_.velocity());
    }
  }
  trajectory_.append(frame);
  append_samples(swimmers, frame.time, frame.mean_flow);
  if (next_frame_ > 0 && next_frame_ % frames_per_cycle_ == 0) close_cycle();
  ++next_frame_;
}

void Recorder::append_samples(const std::vector<SwimmerState>& swimmers, double time, const Vec3& mean_flow) {
  for (std::size_t s = 0; s < swimmers.size(); ++s) {
    SwimmerSample sample{.time = time, .bead_positions = {}, .mean_flow = mean_flow};
    for (int b = 0; b < 3; ++b) sample.bead_positions[b] = swimmers[s].motion[b].position * scales_.cell;
    samples_[s].push_back(sample);
  }
}

void Recorder::close_cycle() {
  for (std::size_t s = 0; s < samples_.size() && !samples_[s].empty(); ++s) {
    const int index = static_cast<int>(swimmers_[s].cycles.size()) + 1;
    swimmers_[s].cycles.push_back(cycle_statistics(index, samples_[s], period_));
    samples_[s].erase(samples_[s].begin(),
                      samples_[s].end() - 1);  // the end of one cycle is the start of the next
  }
}

}  // namespace beadswim
