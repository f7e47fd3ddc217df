#include "beadswim/documents/swimming_document.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <span>

#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/documents/failure_document.hpp"
#include "beadswim/documents/trajectory_file.hpp"
#include "beadswim/io/document_stream.hpp"
#include "beadswim/scene/placed_swimmers.hpp"

namespace beadswim {
namespace {

/// Adds the cycles of the swimmers of a large swarm, which the record does not list, from the trajectory
/// beside the record, if there are cycles. Throws InputError if there is no trajectory, or if it belongs to
/// another run.
RunRecord with_swimmers(RunRecord record, const std::string& source) {
  if (!record.swimmers.empty() || record.swarm.value_or(std::vector<SwarmCycle>()).empty()) return record;
  const std::string path = std::filesystem::path(source).replace_extension(".h5md");
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored))
    throw InputError(source,
                     "the run record contains only statistics of the swarm, because the run has more than {} "
                     "swimmers, and there is no {}; name the trajectory (.h5md) instead",
                     max_swimmers_listed, path);
  RunRecord of_trajectory = run_of_trajectory(path);
  if (!(of_trajectory.driving == record.driving && of_trajectory.units == record.units &&
        of_trajectory.swimmers.front().cycles.size() ==
            record.swarm.value_or(std::vector<SwarmCycle>()).size()))
    throw InputError(source,
                     "the trajectory {} belongs to another run than this record, which does not list its "
                     "swimmers; name the trajectory of the run instead",
                     path);
  record.swimmers = std::move(of_trajectory.swimmers);
  record.scene = std::move(of_trajectory.scene);
  return record;
}

}  // namespace

std::string source_name(const std::string& path) {
  return path == "-" ? "standard input" : path;
}

RunRecord run_from_json(const Json& document, const std::string& source) {
  return with_swimmers(run_record_from_json(document, source), source);
}

std::string schema_of(const Json& document) {
  const bool has_schema =
      document.is_object() && document.contains("schema") && document["schema"].is_string();
  return has_schema ? document["schema"].get<std::string>() : "";
}

std::vector<SourceJson> read_json_documents(const std::string& path, const std::string& wanted) {
  if (is_trajectory(path))
    throw InputError(path, "the file is a trajectory; {} (JSON) is needed here", wanted);
  std::vector<SourceJson> documents;
  DocumentStream stream({path});
  while (const std::optional<StreamMember> member = stream.next()) {
    if (member->text.find_first_not_of(" \t\r\n") == std::string::npos)
      throw InputError(member->source, "the input is empty; {} is needed here", wanted);
    documents.push_back({member->source, parse_json(member->text, member->source)});
  }
  return documents;
}

SwimmingDocument swimming_from_json(const Json& document, const std::string& source) {
  const std::string schema = schema_of(document);
  if (schema.starts_with("beadswim/run/")) return run_from_json(document, source);
  if (schema.starts_with("beadswim/prediction/")) return predictions_from_json(document, source);
  throw InputError(source,
                   "{}; a run record (\"schema\": \"beadswim/run/1\") or a prediction "
                   "(\"beadswim/prediction/1\") is needed here",
                   schema.empty() ? "the document has no key \"schema\""
                                  : "the document has the schema \"" + schema + "\"");
}

ReadDocuments read_documents(
    const std::vector<std::string>& files, const std::string& wanted,
    const std::function<SwimmingDocument(const Json& document, const std::string& source)>& parse) {
  if (files.empty()) throw InputError("FILES", "no file is given; name {} or a trajectory", wanted);
  require_one_standard_input(files);
  ReadDocuments read;
  for (const std::string& path : files) {
    if (is_trajectory(path)) {
      read.documents.push_back({path, run_of_trajectory(path)});
      continue;
    }
    for (const auto& [source, json] : read_json_documents(path, wanted)) {
      if (is_failure(json)) {
        ++read.failures;
      } else {
        read.documents.push_back({source, parse(json, source)});
      }
    }
  }
  return read;
}

const Units& units_of(const SwimmingDocument& document) {
  return std::visit([](const auto& any) -> const Units& { return any.units; }, document);
}

std::vector<int> swimmers_of(const RunRecord& run) {
  std::vector<int> ids;
  for (const SwimmerRecord& swimmer : run.swimmers) ids.push_back(swimmer.id);
  return ids;
}

std::vector<int> swimmers_of(const SwimmingDocument& document) {
  if (const auto* prediction = std::get_if<PredictionDocument>(&document)) return {prediction->swimmer};
  return swimmers_of(std::get<RunRecord>(document));
}

MotionScale motion_scale_of(const RunRecord& run, const SwimmerRecord& swimmer, const CycleChoice& choice,
                            const std::string& source) {
  MotionScale scale{.period = swimmer.period.value_or(run.driving.period)};
  const auto raise = [](double& scale, double value) { scale = std::max(scale, value); };
  for (const CycleStatistics& cycle : select_cycles(swimmer.cycles, choice, source)) {
    raise(scale.speed, cycle.velocity.norm());
    for (const double d : cycle.arm_amplitudes) raise(scale.speed, 2 * std::numbers::pi * d / scale.period);
    for (const double mean : cycle.arm_means) raise(scale.length, mean);
  }
  if (run.scene) {
    double radius = 0;
    for (const auto& [name, type] : run.scene->types) raise(radius, largest_radius(std::span(&type, 1)));
    raise(scale.length, radius);
    raise(scale.speed, run.dimensionless.reynolds_bead * run.scene->fluid.kinematic_viscosity / (2 * radius));
  }
  if (run.mobility && run.mobility->cut_off) scale.numerical_error = run.mobility->tolerance * scale.speed;
  return scale;
}

const SwimmerRecord& find_swimmer(const RunRecord& run, std::optional<int> id, const std::string& source) {
  const auto is_requested = [&](const SwimmerRecord& swimmer) { return !id || swimmer.id == *id; };
  const auto found = std::ranges::find_if(run.swimmers, is_requested);
  if (found != run.swimmers.end()) return *found;
  if (run.swimmers.empty())
    throw InputError(source,
                     "the run record contains only statistics of the swarm, because the run has more than {} "
                     "swimmers; run a smaller cell of the scene (beadswim-layout reduce)",
                     max_swimmers_listed);
  constexpr std::size_t max_ids = 16;  // of a message that is easy to read
  const std::vector<int> ids = swimmers_of(run);
  const auto [low, high] = std::ranges::minmax(ids);
  throw InputError(source, "the run record contains no swimmer with the id {}; the ids in the record are {}",
                   *id, ids.size() <= max_ids ? joined(ids, ", ") : fmt::format("from {} to {}", low, high));
}

MeasuredStroke measured_stroke(const RunRecord& run, std::optional<int> swimmer, const std::string& source) {
  const std::string where = fmt::format("{} {}", Setting::stroke_record, source);
  const SwimmerRecord& record = find_swimmer(run, swimmer, where);
  if (record.cycles.empty())
    throw InputError(where, "swimmer {} has not finished a cycle; run at least one cycle", record.id);
  const CycleStatistics& last = record.cycles.back();
  if (last.arm_amplitudes.size() != 2)
    throw InputError(where,
                     "swimmer {} has {} bonds, but the methods need the stroke of two arms; give a run of "
                     "the paper's three-bead swimmer",
                     record.id, last.arm_amplitudes.size());
  return {.source = source,
          .units = run.units,
          .period = record.period.value_or(run.driving.period),
          .stroke = {.amplitude = last.arm_amplitudes, .phase = last.arm_phases}};
}

}  // namespace beadswim
