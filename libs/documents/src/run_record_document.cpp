#include "beadswim/documents/run_record_document.hpp"

#include <fmt/core.h>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/io/schema.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"
#include "layout_json.hpp"

namespace beadswim {
namespace {

/// Throws InputError if the cycles of a swimmer have different numbers of arms.
void require_equal_arms(const SwimmerRecord& swimmer, std::size_t index, const std::string& source) {
  for (std::size_t c = 0; c < swimmer.cycles.size(); ++c) {
    const CycleStatistics& cycle = swimmer.cycles[c];
    const std::size_t arms = swimmer.cycles.front().arm_amplitudes.size();
    if (cycle.arm_amplitudes.size() == arms && cycle.arm_phases.size() == arms &&
        cycle.arm_means.size() == arms)
      continue;
    throw InputError(
        fmt::format("{}:/swimmers/{}/cycles/{}", source, index, c),
        "the lists arm_amplitudes, arm_phases and arm_means must have the same length in all cycles "
        "of a swimmer; the file was edited: give the record as beadswim-run wrote it");
  }
}

/// Returns the driving for the run record. Omits amplitudes and phase if they differ between swimmers.
DrivingRecord driving_of(const Layout& layout, double base_period) {
  const auto driving = [&](const Swimmer& swimmer) {
    return three_bead_form(layout.resolved_type(swimmer).driving);
  };
  const std::optional<ThreeBeadDriving> first = driving(layout.swimmers.front());
  const bool is_common =
      first && std::ranges::all_of(layout.swimmers, [&](const Swimmer& swimmer) {
        const std::optional<ThreeBeadDriving> other = driving(swimmer);
        return other && other->amplitude == first->amplitude && other->phase == first->phase;
      });
  if (!is_common) return {.period = base_period, .amplitude = std::nullopt, .phase = std::nullopt};
  return {.period = base_period, .amplitude = first->amplitude, .phase = first->phase};
}

}  // namespace

void set_surroundings(const Layout& layout, double base_period, RunRecord& record) {
  record.units = layout.units;
  record.domain = layout.domain;
  if (!layout.flow.is_zero()) record.flow = layout.flow;
  if (!layout.body_force.isZero(0)) record.body_force = layout.body_force;
  record.driving = driving_of(layout, base_period);
}

RunRecord run_record_from_json(const Json& document, const std::string& source) {
  validate_json(document, "run", source);
  RunRecord record = document.get<RunRecord>();
  for (std::size_t s = 0; s < record.swimmers.size(); ++s) require_equal_arms(record.swimmers[s], s, source);
  if (document.contains("scene")) record.scene = scene_from_json(document["scene"], record.units, source);
  return record;
}

Json run_record_to_json(const RunRecord& record, RecordProvenance provenance) {
  Json document{{"schema", "beadswim/run/1"}};
  add_fields(document, record);
  if (record.scene) document["scene"] = scene_to_json(*record.scene);
  if (provenance == RecordProvenance::left_out) {
    document.erase("cost");
    document.erase("provenance");
  }
  return document;
}

}  // namespace beadswim
