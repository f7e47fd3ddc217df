#include "flow/flow_output.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <iterator>

#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/core/sha256.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {
namespace {

/// Returns false for places beyond walls, where a grid that moves with a swimmer may reach.
bool has_fluid(const Domain& domain, const Vec3& place) {
  if (domain.half_space && domain.half_space->height(place) < 0) return false;
  for (int a = 0; a < 3 && domain.box; ++a)
    if (!domain.box->is_periodic(a) && !(place[a] >= 0 && place[a] <= domain.box->lengths[a])) return false;
  return true;
}

long first_step_of_mean(const FlowRequest& request, const ModelPlan& plan) {
  return std::max(0L, plan.steps_in(plan.settings.cycles) - *request.mean_cycles * plan.steps_per_cycle);
}

FlowState state_in(const std::vector<char>& bytes) {
  FlowState state;
  if (bytes.empty()) return state;
  IncomingMessage message(bytes);
  message(state);
  return state;
}

/// Returns a hash of the places of the flow: the swimmer of the frame, and the cells or points.
std::vector<char> hash_of_places(const FlowRequest& request) {
  Sha256 hash;
  const auto& [cells, spacing, origin, mean, swimmer] = request.cells;
  const std::array<double, 8> grid{static_cast<double>(request.swimmer.value_or(-1)),
                                   static_cast<double>(cells[0]),
                                   static_cast<double>(cells[1]),
                                   static_cast<double>(cells[2]),
                                   spacing,
                                   origin[0],
                                   origin[1],
                                   origin[2]};
  hash.update(std::as_bytes(std::span(grid)));
  if (!request.is_grid) hash.update(std::as_bytes(std::span(request.points)));
  const std::string text = hash.hexadecimal();
  return {text.begin(), text.end()};
}

}  // namespace

void require_sums(const FlowRequest& request, const ModelPlan& plan, const std::vector<char>& state) {
  if (!request.mean_cycles) return;
  const long first = first_step_of_mean(request, plan);
  const FlowState earlier = state_in(state);
  if (plan.steps_done <= first || (earlier.first == first && earlier.places == hash_of_places(request)))
    return;
  throw InputError(
      Setting::flow_mean,
      "the last {} cycles begin before the checkpoint, whose run did not sum up the flow at these "
      "places; give fewer, or more {}",
      *request.mean_cycles, Setting::cycles);
}

FlowOutput::FlowOutput(FlowRequest request, const ModelPlan& plan, const Layout& layout,
                       const std::string& path, long done, const Communicator& communicator)
    : request_(std::move(request)),
      plan_(plan),
      communicator_(communicator),
      stem_(path + ".flow"),
      done_(done),
      domain_(layout.domain) {
  const RunSettings& settings = plan.settings;
  state_.places = hash_of_places(request_);
  if (request_.mean_cycles) {
    state_.first = first_step_of_mean(request_, plan);
    const long per_cycle =
        std::min<long>(settings.frames_per_cycle, plan.steps_per_cycle / plan.step_multiple);
    samples_ = *request_.mean_cycles * std::max(1L, per_cycle);
  } else {
    interval_ = plan.whole_steps(steps_between(*settings.flow_every, plan.steps_per_cycle));
  }
  for (const PlacedSwimmer& swimmer : plan.swimmers) {
    if (request_.swimmer != swimmer.id) continue;
    frame_swimmer_ = static_cast<int>(&swimmer - plan.swimmers.data());
    for (int a = 0; a < 3; ++a) state_.axes[a] = swimmer.orientation.col(a);
    frame_type_ = layout.types.at(std::ranges::find(layout.swimmers, swimmer.id, &Swimmer::id)->type);
  }
  std::error_code failure;
  if (communicator_.is_root() && request_.is_grid) std::filesystem::create_directories(stem_, failure);
  int reason = failure.value();
  MPI_Bcast(&reason, 1, MPI_INT, 0, communicator_.get());
  if (reason != 0) {
    throw InputError(request_.mean_cycles ? Setting::flow_mean : Setting::flow_every,
                     "the folder {} cannot be created: {}; remove or rename any file of that name", stem_,
                     std::strerror(reason));
  }
  if (!communicator_.is_root()) return;
  if (!request_.is_grid) {
    keep_rows_until(done);
  } else if (done > 0) {
    remove_after(done);
  }
}

long FlowOutput::step_of_sample(long number) const {
  const double span = static_cast<double>(*request_.mean_cycles * plan_.steps_per_cycle);
  const double step =
      static_cast<double>(state_.first) + span * static_cast<double>(number) / static_cast<double>(samples_);
  return plan_.whole_steps(std::lround(step));
}

double FlowOutput::weight_of_sample(long number) const {
  const long next = number < samples_ ? step_of_sample(number + 1) - step_of_sample(number)
                                      : step_of_sample(1) - step_of_sample(0);
  const long before = step_of_sample(number) - step_of_sample(number - 1);
  return static_cast<double>(next + before) / 2 /
         static_cast<double>(step_of_sample(samples_) - step_of_sample(0));
}

/// Returns the number of the sample that is taken at a step; 0 if there is none.
long FlowOutput::sample_at(long step) const {
  if (step <= state_.first) return 0;
  const double share = static_cast<double>(step - state_.first) /
                       static_cast<double>(*request_.mean_cycles * plan_.steps_per_cycle);
  const long near = std::lround(share * static_cast<double>(samples_));
  for (const long number : {near - 1, near, near + 1})
    if (number >= 1 && number <= samples_ && step_of_sample(number) == step) return number;
  return 0;
}

bool FlowOutput::is_due(long step) const {
  return request_.mean_cycles ? sample_at(step) > 0 : step % interval_ == 0;
}

Eigen::Matrix3d FlowOutput::orientation() const {
  Eigen::Matrix3d orientation;
  for (int a = 0; a < 3; ++a) orientation.col(a) = state_.axes[a];
  return orientation;
}

void FlowOutput::move_frame(const Model& model) {
  if (!request_.swimmer) return;
  const std::vector<SwimmerMotion> swimmers = model.gather_swimmers(0);
  if (communicator_.is_root()) {
    const SwimmerMotion& beads = swimmers[frame_swimmer_];
    BeadVectors positions(3, std::ssize(beads));
    for (std::size_t b = 0; b < beads.size(); ++b) positions.col(b) = plan_.units.length * beads[b].position;
    frame_place_ = positions.rowwise().mean();
    const Eigen::Matrix3d turned = fitted_orientation(frame_type_, positions, orientation());
    for (int a = 0; a < 3; ++a) state_.axes[a] = turned.col(a);
  }
  broadcast_doubles(frame_place_.data(), 3, communicator_);
  broadcast_doubles(state_.axes[0].data(), 9, communicator_);
}

void FlowOutput::take(Model& model) {
  const long step = model.steps_done();
  if (request_.is_on_lattice) {
    state_.steps.push_back(step);
    const std::filesystem::path folder = std::filesystem::path(stem_).parent_path();
    std::vector<std::string> files;
    for (const PvdEntry& entry : entries_of(step)) files.push_back(folder / entry.file);
    model.write_flow(files);
    write_index();
    return;
  }
  move_frame(model);
  const Eigen::Matrix3d axes = orientation();
  std::vector<Vec3> places;
  places.reserve(request_.points.size());
  for (const Vec3& point : request_.points) places.emplace_back(frame_place_ + axes * point);
  std::vector<PointFlow> flow = model.flow_at(places);
  for (std::size_t p = 0; p < flow.size(); ++p) {
    PointFlow& at = flow[p];
    if (!has_fluid(domain_, places[p])) at = {.pressure = at.pressure ? std::optional(0.0) : std::nullopt};
    at.velocity = axes.transpose() * at.velocity;
  }
  if (!request_.mean_cycles) return write_flow(step, flow);
  const long number = sample_at(step);
  const double weight = weight_of_sample(number);
  state_.sums.resize(flow.size(),
                     {.pressure = flow.empty() || !flow[0].pressure ? std::nullopt : std::optional(0.0)});
  for (std::size_t p = 0; p < flow.size(); ++p) {
    state_.sums[p].velocity += weight * flow[p].velocity;
    if (flow[p].pressure) *state_.sums[p].pressure += weight * *flow[p].pressure;
    state_.sums[p].bead += weight * (flow[p].bead > 0 ? 1 : 0);
  }
  if (number == samples_) write_flow(step, state_.sums);
}

void FlowOutput::write_flow(long step, const std::vector<PointFlow>& flow) {
  if (!communicator_.is_root()) return;
  const bool has_pressure = flow[0].pressure.has_value();
  if (!request_.is_grid) {
    const double cycle = static_cast<double>(step) / static_cast<double>(plan_.steps_per_cycle);
    if (rows_.empty()) rows_ = fmt::format("cycle,x,y,z,ux,uy,uz{}\n", has_pressure ? ",pressure" : "");
    for (std::size_t p = 0; p < flow.size(); ++p) {
      const Vec3 &x = request_.points[p], &u = flow[p].velocity;
      fmt::format_to(std::back_inserter(rows_), "{},{},{},{},{},{},{}", cycle, x[0], x[1], x[2], u[0], u[1],
                     u[2]);
      if (has_pressure) fmt::format_to(std::back_inserter(rows_), ",{}", *flow[p].pressure);
      rows_ += '\n';
    }
    write_text(stem_ + ".csv", rows_);
    return;
  }
  state_.steps.push_back(step);
  const std::size_t layer = static_cast<std::size_t>(request_.cells.cells[0]) * request_.cells.cells[1];
  const auto field = [&](const std::string& name, int components, auto value) {
    return VtiField{.name = name, .components = components, .plane = [=, &flow](int z) {
                      std::vector<float> plane;
                      for (std::size_t p = layer * z; p < layer * (z + 1); ++p)
                        for (int k = 0; k < components; ++k)
                          plane.push_back(static_cast<float>(value(flow[p], k)));
                      return plane;
                    }};
  };
  std::vector<VtiField> fields{
      field("velocity", 3, [](const PointFlow& at, int k) { return at.velocity[k]; }),
      field("bead", 1, [](const PointFlow& at, int) { return at.bead; })};
  if (has_pressure)
    fields.push_back(field("pressure", 1, [](const PointFlow& at, int) { return *at.pressure; }));
  const std::filesystem::path folder = std::filesystem::path(stem_).parent_path();
  write_vti(folder / entries_of(step)[0].file, request_.cells, fields);
  write_index();
}

std::vector<char> FlowOutput::state() const {
  OutgoingMessage message;
  message(state_);
  return message.bytes();
}

void FlowOutput::restore(const std::vector<char>& bytes) {
  const FlowState earlier = state_in(bytes);
  if (earlier.places == state_.places) {
    state_.axes = earlier.axes;
    if (earlier.first == state_.first) state_.sums = earlier.sums;
  }
  if (done_ == 0 || !request_.is_grid) return;
  const std::filesystem::path folder = std::filesystem::path(stem_).parent_path();
  const auto exists = [&](const PvdEntry& entry) { return std::filesystem::exists(folder / entry.file); };
  std::ranges::copy_if(earlier.steps, std::back_inserter(state_.steps),
                       [&](long step) { return std::ranges::all_of(entries_of(step), exists); });
  write_index();
}

void FlowOutput::write_index() const {
  if (!communicator_.is_root()) return;
  std::vector<PvdEntry> entries;
  for (const long step : state_.steps) std::ranges::copy(entries_of(step), std::back_inserter(entries));
  write_pvd(stem_ + ".pvd", entries);
}

/// Keeps the rows of an earlier run until its step `done`.
void FlowOutput::keep_rows_until(long done) {
  std::error_code ignored;
  if (done == 0 || !std::filesystem::exists(stem_ + ".csv", ignored)) return;
  const double cycle = (static_cast<double>(done) + 0.5) / static_cast<double>(plan_.steps_per_cycle);
  const std::string text = read_text(stem_ + ".csv");
  for (std::size_t start = 0, end = 0; (end = text.find('\n', start)) != text.npos; start = end + 1)
    if (start == 0 || std::strtod(text.c_str() + start, nullptr) < cycle)
      rows_.append(text, start, end + 1 - start);
}

void FlowOutput::remove_after(long done) const {
  std::error_code ignored;
  std::vector<std::filesystem::path> later;
  for (const auto& file : std::filesystem::directory_iterator(stem_, ignored)) {
    const std::filesystem::path& path = file.path();
    const std::string name = path.stem().string(), number = name.substr(0, name.find('-'));
    const bool is_step = !number.empty() && number.find_first_not_of("0123456789") == std::string::npos;
    if (path.extension() == ".vti" && is_step && number.size() < 19 && std::stol(number) > done)
      later.push_back(path);
  }
  for (const auto& path : later) std::filesystem::remove(path, ignored);
}

std::vector<PvdEntry> FlowOutput::entries_of(long step) const {
  const int levels = request_.is_on_lattice ? plan_.flow_levels() : 1;
  std::vector<PvdEntry> entries;
  for (int n = 0; n < levels; ++n) {
    const std::string level = levels == 1 ? "" : fmt::format("-{}", n);
    entries.push_back(
        {.time = static_cast<double>(step) * plan_.time_step,
         .file = fmt::format("{}/{:09}{}.vti", std::filesystem::path(stem_).filename().string(), step, level),
         .part = n});
  }
  return entries;
}

}  // namespace beadswim
