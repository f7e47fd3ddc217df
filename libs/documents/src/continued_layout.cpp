#include "beadswim/documents/continued_layout.hpp"

#include <cmath>
#include <numbers>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/trajectory_file.hpp"
#include "beadswim/scene/combine.hpp"

namespace beadswim {
namespace {

/// Returns the index of the last frame at the end of this cycle, or of any cycle.
std::size_t frame_after_cycle(const TrajectoryFile& file, std::optional<int> cycle, const std::string& flag) {
  const std::vector<double> times = file.reader.times();
  const double period = base_period(file.layout);
  for (std::size_t frame = times.size(); frame-- > 0;)
    if (const auto cycles = whole_cycles(times[frame], period); cycles && cycle.value_or(*cycles) == *cycles)
      return frame;
  throw InputError(flag, "{} has no frame at the end of cycle {}; its frames end after {:.4g} cycles",
                   file.source, cycle.value_or(0), times.back() / period);
}

/// Continues the phase of a swimmer's drives: sin(2 pi t/T + phi) at the time t is that of the time 0 with
/// phi + 2 pi t/T.
void continue_driving(Layout& layout, Swimmer& swimmer, double time) {
  Driving driving = layout.driving_of(swimmer);
  if (whole_cycles(time, driving.period)) return;
  constexpr double turn = 2 * std::numbers::pi;
  driving.phase_offset = std::remainder(driving.phase_offset + turn * time / driving.period, turn);
  swimmer.driving = driving;
}

/// Places the swimmer where its beads are. The orientation fits the shape at rest best.
void place(Swimmer& swimmer, const SwimmerType& type, const std::vector<Vec3>& beads) {
  const Eigen::Matrix3d before = swimmer.orientation();
  if (type.driving.frame != DrivingFrame::initial_axis) {
    const Eigen::Matrix3d fit = fitted_orientation(type, columns_of_beads(beads), before);
    turn_swimmer(swimmer, type, Eigen::Quaterniond(Eigen::Matrix3d(fit * before.transpose())));
  }
  const BeadVectors at_rest = columns_of_beads(rest_positions(type, Vec3::Zero(), swimmer.orientation()));
  swimmer.position = (columns_of_beads(beads) - at_rest).rowwise().mean();
  swimmer.start = SwimmerStart{.positions = beads};
}

}  // namespace

LayoutDocument layout_after_cycle(const std::string& path, std::optional<int> cycle,
                                  const std::string& flag) {
  const TrajectoryFile file = open_trajectory(path);
  const std::string source = path + ":/parameters/layout";
  LayoutDocument document = layout_from_json(parse_json(file.reader.header().layout, source), source);
  document.made_by = {};
  Layout& layout = document.layout;
  const TrajectoryFrame frame = file.reader.frame(frame_after_cycle(file, cycle, flag));
  auto bead = frame.positions.begin();
  for (const std::size_t s : file.in_layout) {
    Swimmer& swimmer = layout.swimmers[s];
    const SwimmerType type = layout.resolved_type(swimmer);
    const auto end = bead + std::ssize(type.beads);
    place(swimmer, type, {bead, end});
    bead = end;
    swimmer.move_to(wrapped(swimmer.position, layout.domain.box));
    continue_driving(layout, swimmer, frame.time);
  }
  return document;
}

}  // namespace beadswim
