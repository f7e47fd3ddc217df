#include "record/recorder.hpp"

#include <Eigen/Geometry>
#include <limits>
#include <numbers>
#include <tuple>

#include "beadswim/collinear/oseen.hpp"
#include "beadswim/compare/driving_power.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"

namespace beadswim {
namespace {

/// Interpolates linearly between `first` (for part = 0) and `last` (for part = 1). std::lerp makes the result
/// exact if `first` and `last` are equal.
Vec3 interpolate(double part, const Vec3& first, const Vec3& last) {
  Vec3 result;
  for (int a = 0; a < 3; ++a) result[a] = std::lerp(first[a], last[a], part);
  return result;
}

/// Returns the method of theory with the mobility of the model; for the models lbm and multipole, the exact
/// mobility.
const Method& towing_method(RunModel model) {
  const bool has_pairs = model == RunModel::oseen || model == RunModel::rpy;
  return find_method(has_pairs ? to_text(model) + "-ode" : "multipole-ode");
}

/// Returns the log of the swimmer with this id, or logs.end(). `logs` are in the order of their ids.
auto find_log(auto& logs, int id) {
  const auto log = std::ranges::lower_bound(logs, id, {}, [](const auto& each) { return each.record.id; });
  return log != logs.end() && log->record.id == id ? log : logs.end();
}

}  // namespace

CycleStatistics widest_cycle(const Layout& layout) {
  std::size_t arms = 1;
  for (const auto& [name, type] : layout.types) arms = std::max(arms, type.bonds.size());
  CycleStatistics cycle;
  for (std::vector<double>* column : {&cycle.arm_amplitudes, &cycle.arm_phases, &cycle.arm_means})
    column->resize(arms);
  return cycle;
}

Recorder::Recorder(const ModelPlan& plan, const Layout& layout, TrajectoryWriter* trajectory,
                   const Communicator& communicator)
    : plan_(plan),
      layout_(layout),
      communicator_(communicator),
      frames_per_cycle_(
          static_cast<int>(std::min<long>(plan.settings.frames_per_cycle, plan.steps_per_cycle))),
      dynamic_viscosity_(layout.fluid.dynamic_viscosity()),
      towing_method_(towing_method(plan.settings.model)),
      pairs_(plan.settings.model == RunModel::oseen ? oseen_pairs : rotne_prager_tensor),
      trajectory_(trajectory) {
  for (const double period : plan.periods) schedules_.emplace_back(period, frames_per_cycle_);
  if (!communicator.is_root()) return;
  const Swarm swarm = placed_swimmers(layout);
  for (std::size_t s = 0; s < swarm.swimmers.size(); ++s) {
    SwimmerType type = swarm.type_of(swarm.swimmers[s]);
    if (plan.lattice()) {
      const std::vector<double>& softening = plan.lattice()->softening[plan.swimmers[s].type];
      for (std::size_t k = 0; k < softening.size(); ++k) type.angles[k].stiffness *= softening[k];
    }
    const double period = type.driving.period;
    logs_.push_back({.record = {.id = swarm.swimmers[s].id,
                                .cycles = {},
                                .period = period == plan.base_period ? std::nullopt : std::optional(period)},
                     .type = type,
                     .initial_orientation = swarm.swimmers[s].orientation,
                     .samples_per_cycle = schedules_[plan.swimmers[s].type].per_cycle(),
                     .samples = {}});
  }
}

std::vector<SwimmerRecord> Recorder::swimmers() const {
  std::vector<SwimmerRecord> records;
  for (const SwimmerLog& log : logs_) records.push_back(log.record);
  return records;
}

double Recorder::time_of_frame(long frame) const {
  return static_cast<double>(frame) / frames_per_cycle_ * static_cast<double>(plan_.steps_per_cycle);
}

long Recorder::step_of_frame(long frame) const {
  return std::lround(time_of_frame(frame));
}

void Recorder::sample(const Model& model) {
  const long step = model.steps_done();
  if (step != next_sample_) return;
  const std::vector<DipoleSample> dipoles = model.dipoles();
  for (int swimmer = 0; swimmer < model.own_swimmers(); ++swimmer) {
    const SwimmerIdentity name = model.own_swimmer(swimmer);
    const SamplingSchedule& schedule = schedules_[name.type];
    if (schedule.next_step() != step) continue;
    const long number = schedule.number_at(step);
    // The end of a cycle is sampled at its exact time, which can differ from the time of this step by up to
    // half a time step.
    const bool ends_cycle = number % schedule.per_cycle() == 0;
    const double time = ends_cycle ? schedule.time_of(number) : static_cast<double>(step);
    const PositionSample position_sample{
        .id = name.id,
        .number = number,
        .time = time,
        .dipole = dipoles[swimmer],
        .positions = model.bead_positions(swimmer, time - static_cast<double>(step))};
    pending_samples_(position_sample);
  }
  advance_schedules(step + 1);
}

void Recorder::advance_schedules(long step) {
  next_sample_ = std::numeric_limits<long>::max();
  for (SamplingSchedule& schedule : schedules_) {
    schedule.advance_to(step);
    next_sample_ = std::min(next_sample_, schedule.next_step());
  }
}

void Recorder::gather_samples() {
  IncomingMessage arrived(gather_bytes(pending_samples_.bytes(), communicator_));
  pending_samples_ = {};
  while (!arrived.is_at_end()) arrived(gathered_.emplace_back());
}

void Recorder::store_samples(const FlowSample& now) {
  std::ranges::sort(gathered_, {}, [](const PositionSample& position_sample) {
    return std::tuple(position_sample.id, position_sample.number);
  });
  for (const PositionSample& position_sample : gathered_) {
    store_sample(*find_log(logs_, position_sample.id), position_sample, now);
  }
  gathered_.clear();
}

void Recorder::store_sample(SwimmerLog& log, const PositionSample& position_sample, const FlowSample& now) {
  const double time = position_sample.time * plan_.time_step;
  const double part =
      now.time > last_frame_.time ? (time - last_frame_.time) / (now.time - last_frame_.time) : 1;
  SwimmerSample sample{.time = time,
                       .bead_positions = {},
                       .mean_flow = interpolate(part, last_frame_.mean_flow, now.mean_flow),
                       .dipole = position_sample.dipole};
  for (double& component : sample.dipole.present) component *= plan_.units.energy();
  for (double& component : sample.dipole.integral) component *= plan_.units.energy() * plan_.units.time;
  for (const Vec3& position : position_sample.positions)
    sample.bead_positions.push_back(position * plan_.units.length);
  log.samples.push_back(sample);
  if (position_sample.number == 0 || position_sample.number % log.samples_per_cycle != 0) return;
  const int index = static_cast<int>(position_sample.number / log.samples_per_cycle);
  std::vector<CycleStatistics>& cycles = log.record.cycles;
  if (logs_.size() > max_swimmers_listed) cycles.clear();
  cycles.push_back(statistics_of(log, index));
  log.samples.erase(log.samples.begin(),
                    log.samples.end() - 1);  // the last sample also begins the next cycle
}

CycleStatistics Recorder::statistics_of(const SwimmerLog& log, int index) const {
  CycleStatistics cycle =
      cycle_statistics(index, log.samples, log.type, log.initial_orientation, layout_.flow);
  cycle.power = driving_power(log.type, log.initial_orientation, log.samples);
  cycle.dipole = mean_dipole(log.samples, log.type, log.initial_orientation);
  if (!cycle.power || logs_.size() > max_swimmers_listed) return cycle;
  if (const auto drag = drag_in_cycle(log, cycle))
    cycle.efficiency =
        lighthill_efficiency(*drag, velocity_relative_to_fluid(cycle, layout_.domain.box), *cycle.power);
  return cycle;
}

std::optional<double> Recorder::drag_in_cycle(const SwimmerLog& log, const CycleStatistics& cycle) const {
  if (const std::optional<ThreeBeadSwimmer> three = three_bead_form(log.type)) {
    const auto& [first, second, third] = three->beads;
    const CollinearSwimmer swimmer{.radius = {first.radius, second.radius, third.radius},
                                   .viscosity = dynamic_viscosity_};
    return towing_drag(towing_method_, swimmer, {cycle.arm_means[0], cycle.arm_means[1]});
  }
  const BeadVectors shape = mean_shape(log.samples, log.type, log.initial_orientation);
  const ShapedSwimmer swimmer{log.type, Eigen::Matrix3d::Identity(), dynamic_viscosity_};
  return towing_drag(shape, Vec3::UnitX(), pair_mobility(swimmer, pairs_));
}

void Recorder::record(const Model& model, const ModelTotals& totals) {
  const long step = model.steps_done();
  const double time = time_of_frame(next_frame_);
  const std::vector<SwimmerMotion> swimmers = model.gather_swimmers(time - static_cast<double>(step));
  const FlowSample now{.time = static_cast<double>(step) * plan_.time_step, .mean_flow = totals.mean_flow};
  TrajectoryFrame frame{.step = step,
                        .time = time * plan_.time_step,
                        .positions = {},
                        .velocities = {},
                        .mean_flow = now.mean_flow,
                        .momentum = totals.momentum.value_or(Vec3::Zero())};
  for (const SwimmerMotion& swimmer : swimmers) {
    for (const BeadMotion& bead : swimmer) {
      frame.positions.push_back(bead.position * plan_.units.length);
      frame.velocities.push_back(bead.velocity * plan_.units.velocity());
    }
  }
  if (plan_.settings.frames_with == FrameContent::forces) add_forces(model, frame);
  if (trajectory_ != nullptr) trajectory_->append(frame);
  if (layout_.fluid.thermal_energy == 0) {
    record_turns(swimmers);
  } else if (next_frame_ % frames_per_cycle_ == 0) {
    extend_paths(swimmers);
  }
  gather_samples();
  store_samples(now);
  last_frame_ = now;
  if (is_cycle_end()) {
    if (trajectory_ != nullptr) append_cycles(frame.step, frame.time);
    if (swimmers.size() > 1) append_swarm(swimmers, frame.momentum);
  }
  ++next_frame_;
}

void Recorder::add_forces(const Model& model, TrajectoryFrame& frame) {
  const FluidForces of_fluid = model.gather_fluid_forces();
  const auto steps = static_cast<double>(frame.step - step_of_frame(next_frame_ - 1));
  frame.forces = of_fluid.present;
  frame.forces.resize(frame.positions.size(), Vec3::Zero());
  fluid_impulse_.resize(of_fluid.integral.size(), Vec3::Zero());
  for (std::size_t b = 0; b < fluid_impulse_.size() && next_frame_ > 0; ++b)
    frame.forces[b] = (of_fluid.integral[b] - fluid_impulse_[b]) / steps;
  fluid_impulse_ = of_fluid.integral;
  for (Vec3& force : frame.forces) force *= plan_.units.force();
  auto first = frame.positions.begin();
  for (std::size_t s = 0; s < logs_.size() && first != frame.positions.end(); ++s) {
    const SwimmerType& type = logs_[s].type;
    const BeadVectors beads = columns_of_beads({first, first + std::ssize(type.beads)});
    const BeadVectors drives = driving_forces(type, frame.time, beads, logs_[s].initial_orientation);
    for (const auto drive : drives.colwise()) frame.drives.emplace_back(drive);
    first += std::ssize(type.beads);
  }
}

// The rotation between two samples is estimated from the velocities at a frame: from the positions alone, it
// would be known up to whole turns only.
void Recorder::record_turns(const std::vector<SwimmerMotion>& swimmers) {
  for (std::size_t s = 0; s < swimmers.size(); ++s) {
    const SwimmerLog& log = logs_[s];
    const double interval = log.type.driving.period / log.samples_per_cycle;
    const double moment = 0.1 * plan_.time_step;  // so short that velocities change little
    std::vector<Vec3> now, later;
    for (const BeadMotion& bead : swimmers[s]) {
      now.push_back(bead.position * plan_.units.length);
      later.push_back(now.back() + moment * plan_.units.velocity() * bead.velocity);
    }
    const Eigen::Matrix3d start =
        fitted_orientation(log.type, columns_of_beads(now), log.initial_orientation);
    const Eigen::Matrix3d end = fitted_orientation(log.type, columns_of_beads(later), start);
    const double angle = Eigen::AngleAxisd(end * start.transpose()).angle();
    largest_turn_ = std::max(largest_turn_, angle * interval / moment);
  }
}

void Recorder::extend_paths(const std::vector<SwimmerMotion>& swimmers) {
  paths_.resize(swimmers.size());
  for (std::size_t s = 0; s < swimmers.size(); ++s) {
    std::vector<Vec3> positions;
    for (const BeadMotion& bead : swimmers[s]) positions.push_back(bead.position * plan_.units.length);
    paths_[s].append(logs_[s].type, positions, logs_[s].initial_orientation);
  }
}

std::vector<RunWarning> Recorder::warnings() const {
  constexpr double allowed = 0.25;
  std::vector<RunWarning> warnings;
  const double turns = largest_turn_ / (2 * std::numbers::pi);
  if (turns > allowed)
    add_warning(warnings, "fast-rotation",
                "a swimmer rotates by up to {:.2g} turns between two samples, so that angular velocity, "
                "velocity and axis in the record can be wrong; use at least {:.0f} {}",
                turns, std::ceil(turns / allowed * frames_per_cycle_), Setting::frames_per_cycle);
  return warnings;
}

void Recorder::append_cycles(long step, double time) {
  std::vector<CycleStatistics> last;
  for (const SwimmerLog& log : logs_) {
    const std::vector<CycleStatistics>& cycles = log.record.cycles;
    last.push_back(cycles.empty() ? record_of_nan<CycleStatistics>() : cycles.back());
  }
  trajectory_->append(
      {.step = step, .time = time, .columns = columns_of(std::move(last), widest_cycle(layout_))});
}

void Recorder::append_swarm(const std::vector<SwimmerMotion>& swimmers, const Vec3& momentum) {
  std::vector<SwarmMember> members;
  for (std::size_t s = 0; s < swimmers.size(); ++s) {
    const SwimmerMotion& motion = swimmers[s];
    std::vector<Vec3> positions;
    for (const BeadMotion& bead : motion) positions.push_back(bead.position);
    const SwimmerLog& log = logs_[s];
    SwarmMember& member = members.emplace_back();
    member.axis = axis_of(log.type, positions, log.initial_orientation);
    member.initial_axis = log.initial_orientation.col(0);
    if (!log.record.cycles.empty()) member.last_cycle = log.record.cycles.back();
    for (std::size_t b = 0; b < motion.size(); ++b) {
      member.centre += motion[b].position * plan_.units.length / static_cast<double>(motion.size());
      const double speed = motion[b].velocity.norm() * plan_.units.velocity();
      const double spin = motion[b].angular_velocity.norm() / plan_.units.time;
      member.kinetic_energy += 0.5 * mass(log.type.beads[b]) * speed * speed +
                               0.5 * moment_of_inertia(log.type.beads[b]) * spin * spin;
    }
  }
  const int index = static_cast<int>(next_frame_ / frames_per_cycle_);
  swarm_.push_back(
      {.statistics = swarm_statistics(index, members, layout_.domain.box), .momentum = momentum});
}

template <class Message>
void Recorder::transfer(Message& message) {
  message(next_frame_, last_frame_.time, last_frame_.mean_flow, fluid_impulse_, paths_, largest_turn_,
          gathered_, swarm_);
  for (SwimmerLog& log : logs_) message(log.samples, log.record.cycles);
}

std::vector<char> Recorder::state() {
  gather_samples();
  OutgoingMessage message;
  if (communicator_.is_root()) transfer(message);
  return message.bytes();
}

bool Recorder::is_consistent_with(long steps_done) const {
  const bool is_next =
      next_frame_ > 0 && next_frame_ <= steps_done + 1 && step_of_frame(next_frame_) > steps_done;
  const auto has_all_beads = [](const SwimmerLog& log, const std::vector<Vec3>& positions) {
    return positions.size() == log.type.beads.size();
  };
  return is_next &&
         std::ranges::all_of(gathered_,
                             [&](const PositionSample& position_sample) {
                               const auto log = find_log(logs_, position_sample.id);
                               return position_sample.number >= 0 && log != logs_.end() &&
                                      has_all_beads(*log, position_sample.positions);
                             }) &&
         std::ranges::all_of(logs_, [&](const SwimmerLog& log) {
           return std::ranges::all_of(log.samples, [&](const SwimmerSample& sample) {
             return has_all_beads(log, sample.bead_positions);
           });
         });
}

void Recorder::restore(std::vector<char> state, long steps_done) {
  advance_schedules(steps_done + 1);
  if (communicator_.is_root()) {
    IncomingMessage message(std::move(state));
    try {
      transfer(message);
    } catch (const DataError&) {
      throw DataError("the run record in the checkpoint is incomplete");
    }
    if (!message.is_at_end() || !is_consistent_with(steps_done))
      throw DataError("the run record in the checkpoint belongs to another run");
  }
  MPI_Bcast(&next_frame_, 1, MPI_LONG, 0, communicator_.get());
}

}  // namespace beadswim
