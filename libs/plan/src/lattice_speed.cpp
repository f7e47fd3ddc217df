#include "beadswim/plan/lattice_speed.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <utility>

#include "beadswim/core/error.hpp"
#include "beadswim/core/median.hpp"
#include "beadswim/core/version.hpp"
#include "beadswim/coupling/coupled_system.hpp"
#include "beadswim/coupling/lattice_memory.hpp"
#include "beadswim/coupling/refinement.hpp"
#include "beadswim/io/fields_json.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"

namespace beadswim {
namespace {

constexpr std::array edges{12, 24, 48, 96};  // edges of a rank's block [cell]; 12 fits in the cache
constexpr double timing_interval = 0.06;     // duration of one timing [s]
constexpr double short_interval = 0.01;      // duration of one timing in at_present() [s]
constexpr int rounds = 3;

CoupledScene fluid_scene(int edge, Precision precision, int ranks) {
  CoupledScene scene;
  scene.cells = {edge, edge, edge * ranks};
  scene.boundary.fill(Boundary::periodic);
  scene.precision = precision;
  scene.bead_boundary = BeadScheme::mr;
  return scene;
}

/// Returns a scene with swimmers at rest side by side. Beads have a radius of 4 cells. The volume fraction of
/// the beads is that of the swarm in the paper.
CoupledScene scene_with_beads(Precision precision, BeadScheme scheme, int ranks) {
  CoupledScene scene = fluid_scene(64, precision, ranks);
  scene.bead_boundary = scheme;
  ThreeBeadSwimmer type;
  type.beads.fill({.radius = 4, .density = 1});
  type.springs.fill({.stiffness = 0.05, .rest_length = 21, .damping = 0});
  type.angular_stiffness = 200;
  type.driving = {.amplitude = {0, 0}, .phase = 0, .period = 2000, .frame = DrivingFrame::lab};
  scene.types = {swimmer_type(type)};
  for (int z = 0; z < 3 * ranks; ++z) {
    for (int y = 0; y < 3; ++y) {
      const Vec3 place(32.3, 21.3 * y + 10.1, 21.3 * z + 10.2);
      scene.swimmers.push_back({.id = static_cast<int>(scene.swimmers.size()), .type = 0, .position = place});
    }
  }
  return scene;
}

/// Returns the wall time per step until all ranks have finished [s]: the median of `rounds` timings, each of
/// the duration `interval` [s]. Collective.
double seconds_of_step(const CoupledScene& scene, double interval, const Communicator& communicator) {
  CoupledSystem system(scene, communicator);
  const auto seconds_of = [&](int steps) {
    MPI_Barrier(communicator.get());
    const double start = MPI_Wtime();
    for (int n = 0; n < steps; ++n) system.step();
    MPI_Barrier(communicator.get());
    return MPI_Wtime() - start;
  };
  seconds_of(2);
  int steps = 2 * std::max(1, static_cast<int>(interval / 2 / std::max(seconds_of(2) / 2, 1e-7)));
  MPI_Bcast(&steps, 1, MPI_INT, 0, communicator.get());
  std::vector<double> seconds;
  for (int round = 0; round < rounds; ++round) seconds.push_back(seconds_of(steps) / steps);
  double result = median(seconds);
  MPI_Bcast(&result, 1, MPI_DOUBLE, 0, communicator.get());
  return result;
}

/// Returns the core-seconds per cell and step of fluid in blocks with edges of `edge` cells, one per rank.
/// Collective.
double seconds_per_cell(int edge, Precision precision, double interval, const Communicator& communicator) {
  const CoupledScene scene = fluid_scene(edge, precision, communicator.size());
  return seconds_of_step(scene, interval, communicator) / std::pow(edge, 3);
}

/// Returns y at x = `at` by linear interpolation of log y as a function of log x. y is constant outside the
/// range of x.
double interpolated(const std::vector<double>& x, const std::vector<double>& y, double at) {
  if (at <= x.front()) return y.front();
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (at > x[i]) continue;
    const double share = std::log(at / x[i - 1]) / std::log(x[i] / x[i - 1]);
    return y[i - 1] * std::pow(y[i] / y[i - 1], share);
  }
  return y.back();
}

/// Returns the entries that a cache file must contain to be valid for this program and this machine.
Json cache_key(int ranks) {
  return {{"schema", "beadswim/lattice-speed/1"},
          {"version", version() + " (" + revision() + ")"},
          {"processor", processor_name()},
          {"ranks", ranks}};
}

/// Returns the path of the cache file for this number of ranks. The folder is $XDG_CACHE_HOME/beadswim or,
/// without this variable, $HOME/.cache/beadswim. The path is empty if neither variable is set.
std::string speed_cache_path(int ranks) {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value == nullptr ? "" : value);
  };
  std::string folder = variable("XDG_CACHE_HOME");
  if (folder.empty() && !variable("HOME").empty()) folder = variable("HOME") + "/.cache";
  return folder.empty() ? "" : fmt::format("{}/beadswim/lattice-speed-{}.json", folder, ranks);
}

/// Writes the cache file. Errors are ignored: without the file, the next plan measures the speed again.
void write_cache(const Json& document, int ranks) {
  const std::string path = speed_cache_path(ranks);
  if (path.empty()) return;
  try {
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    write_text(path, dump_json(document));
  } catch (const std::exception&) {
  }
}

/// Returns the measured time of lattice steps from the cache file; nullopt if there is no valid cache file.
std::optional<LatticeSpeed> cached_speed(int ranks) {
  const std::string path = speed_cache_path(ranks);
  std::error_code unknown;
  if (path.empty() || !std::filesystem::exists(path, unknown)) return std::nullopt;
  try {
    const Json document = parse_json(read_text(path), path);
    const Json wanted = cache_key(ranks);
    for (const auto& [name, value] : wanted.items())
      if (document.at(name) != value) return std::nullopt;
    return lattice_speed_from_json(document);
  } catch (const std::exception&) {  // a damaged file counts as absent: the speed is measured again
    return std::nullopt;
  }
}

}  // namespace

LatticeSpeed::LatticeSpeed(int ranks, std::vector<PrecisionCost> precisions)
    : ranks_(ranks), precisions_(std::move(precisions)) {
  const auto is_sound = [](const PrecisionCost& own) {
    constexpr double longest = 1;  // upper bound of a plausible cost [s]
    return own.cells.size() == edges.size() && own.seconds_per_cell.size() == edges.size() &&
           own.seconds_per_area.size() == all_values<BeadScheme>.size() && own.cells.front() > 0 &&
           std::ranges::is_sorted(own.cells) && std::ranges::min(own.seconds_per_cell) > 0 &&
           std::ranges::max(own.seconds_per_cell) < longest && std::ranges::min(own.seconds_per_area) >= 0 &&
           std::ranges::max(own.seconds_per_area) < longest;
  };
  if (precisions_.size() != all_values<Precision>.size() || !std::ranges::all_of(precisions_, is_sound))
    throw InputError("precisions",
                     "the table of lattice speeds does not have the format of this program version; measure "
                     "the speeds again");
}

LatticeSpeed LatticeSpeed::measured(const Communicator& communicator) {
  const int ranks = communicator.size();
  std::vector<PrecisionCost> precisions;
  for (const Precision precision : all_values<Precision>) {
    PrecisionCost& own = precisions.emplace_back();
    for (const int edge : edges) {
      own.cells.push_back(std::pow(edge, 3));
      own.seconds_per_cell.push_back(seconds_per_cell(edge, precision, timing_interval, communicator));
    }
    for (const BeadScheme scheme : all_values<BeadScheme>) {
      const CoupledScene scene = scene_with_beads(precision, scheme, ranks);
      const double cells = scene.cells.cast<double>().prod();
      const double fluid_seconds = cells * interpolated(own.cells, own.seconds_per_cell, cells / ranks);
      const double seconds = ranks * seconds_of_step(scene, timing_interval, communicator);
      own.seconds_per_area.push_back(std::max(0.0, seconds - fluid_seconds) / bead_surface(scene));
    }
  }
  return {ranks, std::move(precisions)};
}

LatticeSpeed LatticeSpeed::at_present(const Communicator& communicator) const {
  std::vector<PrecisionCost> now = precisions_;
  for (const Precision precision : all_values<Precision>) {
    PrecisionCost& own = now.at(static_cast<std::size_t>(precision));
    std::vector<double> ratios;
    for (std::size_t i = 0; i < edges.size(); ++i)
      ratios.push_back(seconds_per_cell(edges[i], precision, short_interval, communicator) /
                       own.seconds_per_cell[i]);
    const double ratio = median(ratios);
    for (std::vector<double>* costs : {&own.seconds_per_cell, &own.seconds_per_area})
      for (double& seconds : *costs) seconds *= ratio;
  }
  return {ranks_, std::move(now)};
}

double LatticeSpeed::step(const CoupledScene& scene) const {
  const PrecisionCost& own = precisions_.at(static_cast<std::size_t>(scene.precision));
  const double cells = cost_per_step(scene.all_levels());
  return cells * interpolated(own.cells, own.seconds_per_cell, cells / ranks_) +
         own.seconds_per_area.at(static_cast<std::size_t>(scene.bead_boundary)) * bead_surface(scene);
}

LatticeSpeed speed_of_this_machine(const std::function<void(const std::string&)>& message,
                                   const Communicator& communicator) {
  std::string text;
  if (communicator.is_root()) {
    if (const auto known = cached_speed(communicator.size())) text = lattice_speed_to_json(*known).dump();
  }
  broadcast(text, communicator);
  if (text.empty()) {
    if (communicator.is_root())
      message(
          "measuring how fast this machine updates lattice cells; this measurement is made once and takes "
          "some seconds");
    const LatticeSpeed speed = LatticeSpeed::measured(communicator);
    if (communicator.is_root()) write_cache(lattice_speed_to_json(speed), communicator.size());
    return speed;
  }
  return lattice_speed_from_json(Json::parse(text)).at_present(communicator);
}

Json lattice_speed_to_json(const LatticeSpeed& speed) {
  Json json = cache_key(speed.ranks());
  json["precisions"] = speed.precisions();
  return json;
}

LatticeSpeed lattice_speed_from_json(const Json& json) {
  return {json.at("ranks").get<int>(), json.at("precisions").get<std::vector<PrecisionCost>>()};
}

}  // namespace beadswim
