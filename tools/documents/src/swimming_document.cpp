#include "beadswim/documents/swimming_document.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

void refuse_trajectory(const std::string& path) {
  if (!path.ends_with(".h5md")) return;
  throw InputError(path, "is a trajectory; give the run record (JSON) that beadswim-run printed with it");
}

/// "run" of "beadswim/run/1"; empty if the document does not say what it is.
std::string kind_of(const Json& document) {
  if (!document.is_object() || !document.contains("schema") || !document["schema"].is_string()) return {};
  const std::string schema = document["schema"].get<std::string>();
  const std::size_t first = schema.find('/');
  return first == std::string::npos ? "" : schema.substr(first + 1, schema.find('/', first + 1) - first - 1);
}

bool same_unit(const Units::Unit& a, const Units::Unit& b) {
  return a.name == b.name && a.si_factor == b.si_factor;
}

RunRecord with_swimmers(RunRecord record, const std::string& source) {
  if (!record.swimmers.empty()) return record;
  throw InputError(source,
                   fmt::format("holds statistics of a swarm alone, of over {} swimmers; its swimmers are in "
                               "the trajectory, which beadswim-plot trajectories draws",
                               most_swimmers_listed));
}

}  // namespace

bool same_units(const Units& a, const Units& b) {
  if (a.lattice || b.lattice) return a.lattice == b.lattice;
  return same_unit(a.length, b.length) && same_unit(a.time, b.time) && same_unit(a.mass, b.mass);
}

std::string source_name(const std::string& path) {
  return path == "-" ? "standard input" : path;
}

RunRecord read_run(const std::string& path) {
  refuse_trajectory(path);
  return with_swimmers(read_run_record(path), source_name(path));
}

SwimmingDocument read_swimming(const std::string& path) {
  refuse_trajectory(path);
  const std::string source = source_name(path);
  const Json document = parse_json(read_text(path), source);
  const std::string kind = kind_of(document);
  if (kind == "run") return with_swimmers(run_record_from_json(document, source), source);
  if (kind == "prediction") return predictions_from_json(document, source);
  throw InputError(source, fmt::format("{}; a run record (\"schema\": \"beadswim/run/1\") or a prediction "
                                       "(\"beadswim/prediction/1\") is needed here",
                                       kind.empty() ? "does not say what it is" : "is a " + kind));
}

Swimming swimming_of(const RunRecord& run, const SwimmerRecord& swimmer, const CycleChoice& choice,
                     const std::string& source) {
  std::vector<Swimming> cycles;
  for (const CycleStatistics& cycle : chosen_cycles(swimmer.cycles, choice, source)) {
    cycles.push_back(swimming_in(cycle, run.domain));
  }
  return mean_swimming(cycles);
}

Swimming swimming_of(const Prediction& prediction) {
  return {
      {ComparedQuantity::velocity, {prediction.velocity}},
      {ComparedQuantity::arm_amplitudes, {prediction.stroke.amplitude[0], prediction.stroke.amplitude[1]}},
      {ComparedQuantity::sin_phase_shift, {prediction.sin_phase_shift}}};
}

const SwimmerRecord& find_swimmer(const RunRecord& run, int id, const std::string& source) {
  const auto found = std::find_if(run.swimmers.begin(), run.swimmers.end(),
                                  [id](const SwimmerRecord& swimmer) { return swimmer.id == id; });
  if (found != run.swimmers.end()) return *found;
  std::vector<int> ids;
  for (const SwimmerRecord& swimmer : run.swimmers) ids.push_back(swimmer.id);
  throw InputError(source, fmt::format("holds no swimmer {}; it holds {}", id, fmt::join(ids, ", ")));
}

std::optional<double> driving_period(const PredictionDocument& document) {
  for (const Prediction& prediction : document.predictions) {
    for (const auto& [name, value] : prediction.settings) {
      if (name == "period" && std::holds_alternative<double>(value)) return std::get<double>(value);
    }
  }
  return std::nullopt;
}

}  // namespace beadswim
