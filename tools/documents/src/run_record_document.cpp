#include "beadswim/documents/run_record_document.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "beadswim/io/schema.hpp"
#include "domain_json.hpp"
#include "nullable_json.hpp"
#include "units_json.hpp"

namespace beadswim {
namespace {

constexpr std::array<std::pair<RunStatus, const char*>, 5> status_names{{
    {RunStatus::finished, "finished"},
    {RunStatus::stopped_speed, "stopped-speed"},
    {RunStatus::stopped_time, "stopped-time"},
    {RunStatus::stopped_signal, "stopped-signal"},
    {RunStatus::failed, "failed"},
}};

template <typename Table, typename Value>
std::string name_in(const Table& table, Value value) {
  return std::find_if(table.begin(), table.end(), [&](const auto& entry) { return entry.first == value; })
      ->second;
}

/// The schema lets no other name through.
template <typename Table>
auto value_in(const Table& table, const std::string& name) {
  return std::find_if(table.begin(), table.end(), [&](const auto& entry) { return entry.second == name; })
      ->first;
}

std::optional<double> number_if_any(const Json& json, const char* key) {
  return json.contains(key) ? std::optional(json.at(key).get<double>()) : std::nullopt;
}

using ArmNumbers = std::array<double, 2>;

Json driving_json(const RunRecord& record) {
  Json json = {{"period", record.driving_period}};
  if (record.driving) {
    json["amplitude"] = record.driving->amplitude;
    json["phase"] = record.driving->phase;
  }
  return json;
}

std::optional<DrivingRecord> driving_from(const Json& json) {
  if (!json.contains("amplitude") || !json.contains("phase")) return std::nullopt;
  return DrivingRecord{json.at("amplitude").get<ArmNumbers>(), json.at("phase").get<double>()};
}

Json json_of(const CycleStatistics& cycle) {
  return {{"index", cycle.index},
          {"velocity", vec3_to_json(cycle.velocity)},
          {"axis", vec3_to_json(cycle.axis)},
          {"speed_along_axis", cycle.speed_along_axis},
          {"mean_flow", vec3_to_json(cycle.mean_flow)},
          {"arm_amplitudes", cycle.arm_amplitudes},
          {"arm_phases", cycle.arm_phases},
          {"arm_means", cycle.arm_means}};
}

CycleStatistics cycle_from(const Json& json) {
  CycleStatistics cycle;
  cycle.index = json.at("index").get<int>();
  cycle.velocity = vec3_from_json(json.at("velocity"));
  cycle.axis = vec3_from_json(json.at("axis"));
  cycle.speed_along_axis = json.at("speed_along_axis").get<double>();
  cycle.mean_flow = vec3_from_json(json.at("mean_flow"));
  cycle.arm_amplitudes = json.at("arm_amplitudes").get<ArmNumbers>();
  cycle.arm_phases = json.at("arm_phases").get<ArmNumbers>();
  cycle.arm_means = json.at("arm_means").get<ArmNumbers>();
  return cycle;
}

Json json_of(const SwimmerRecord& swimmer) {
  Json cycles = Json::array();
  for (const CycleStatistics& cycle : swimmer.cycles) cycles.push_back(json_of(cycle));
  Json json{{"id", swimmer.id}};
  if (swimmer.period) json["period"] = *swimmer.period;
  json["cycles"] = cycles;
  return json;
}

Json json_of(const Spread& spread) {
  return {{"mean", spread.mean},
          {"deviation", spread.deviation},
          {"smallest", spread.smallest},
          {"largest", spread.largest}};
}
Json json_of(const std::array<Spread, 2>& arms) {
  return Json::array({json_of(arms[0]), json_of(arms[1])});
}

Json json_of(const SwarmSwimming& swimming) {
  return {{"swimmers", swimming.swimmers},
          {"velocity", vec3_to_json(swimming.velocity)},
          {"velocity_deviation", vec3_to_json(swimming.velocity_deviation)},
          {"speed_along_axis", json_of(swimming.speed_along_axis)},
          {"mean_flow", vec3_to_json(swimming.mean_flow)},
          {"arm_amplitudes", json_of(swimming.arm_amplitudes)},
          {"arm_means", json_of(swimming.arm_means)},
          {"arm_phase_order", swimming.arm_phase_order}};
}

Json json_of(const SwarmCycle& cycle) {
  const SwarmStatistics& swarm = cycle.statistics;
  return {{"index", swarm.index},
          {"swimmers", swarm.swimmers},
          {"swimming", swarm.swimming ? json_of(*swarm.swimming) : Json(nullptr)},
          {"mean_axis", vec3_to_json(swarm.mean_axis)},
          {"polar_order", swarm.polar_order},
          {"nematic_order", swarm.nematic_order},
          {"director", vec3_to_json(swarm.director)},
          {"rotation", json_of(swarm.rotation)},
          {"nearest_neighbour", swarm.nearest_neighbour ? json_of(*swarm.nearest_neighbour) : Json(nullptr)},
          {"kinetic_energy", swarm.kinetic_energy},
          {"momentum", vec3_to_json(cycle.momentum)}};
}

Spread spread_from(const Json& json) {
  return {.mean = json.at("mean").get<double>(),
          .deviation = json.at("deviation").get<double>(),
          .smallest = json.at("smallest").get<double>(),
          .largest = json.at("largest").get<double>()};
}
std::array<Spread, 2> arms_from(const Json& json) {
  return {spread_from(json.at(0)), spread_from(json.at(1))};
}

SwarmSwimming swarm_swimming_from(const Json& json) {
  return {.swimmers = json.at("swimmers").get<int>(),
          .velocity = vec3_from_json(json.at("velocity")),
          .velocity_deviation = vec3_from_json(json.at("velocity_deviation")),
          .speed_along_axis = spread_from(json.at("speed_along_axis")),
          .mean_flow = vec3_from_json(json.at("mean_flow")),
          .arm_amplitudes = arms_from(json.at("arm_amplitudes")),
          .arm_means = arms_from(json.at("arm_means")),
          .arm_phase_order = json.at("arm_phase_order").get<ArmNumbers>()};
}

SwarmCycle swarm_cycle_from(const Json& json) {
  SwarmCycle cycle{.statistics = {}, .momentum = vec3_from_json(json.at("momentum"))};
  SwarmStatistics& swarm = cycle.statistics;
  swarm.index = json.at("index").get<int>();
  swarm.swimmers = json.at("swimmers").get<int>();
  if (!json.at("swimming").is_null()) swarm.swimming = swarm_swimming_from(json.at("swimming"));
  swarm.mean_axis = vec3_from_json(json.at("mean_axis"));
  swarm.polar_order = json.at("polar_order").get<double>();
  swarm.nematic_order = json.at("nematic_order").get<double>();
  swarm.director = vec3_from_json(json.at("director"));
  swarm.rotation = spread_from(json.at("rotation"));
  if (!json.at("nearest_neighbour").is_null())
    swarm.nearest_neighbour = spread_from(json.at("nearest_neighbour"));
  swarm.kinetic_energy = json.at("kinetic_energy").get<double>();
  return cycle;
}

SwimmerRecord swimmer_from(const Json& json) {
  SwimmerRecord swimmer{
      .id = json.at("id").get<int>(), .cycles = {}, .period = number_if_any(json, "period")};
  for (const Json& cycle : json.at("cycles")) swimmer.cycles.push_back(cycle_from(cycle));
  return swimmer;
}

Json json_of(const std::optional<MomentumRecord>& momentum) {
  if (!momentum) return nullptr;
  return {{"total", vec3_to_json(momentum->total)}, {"initial", vec3_to_json(momentum->initial)}};
}

std::optional<MomentumRecord> momentum_from(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return MomentumRecord{vec3_from_json(json.at("total")), vec3_from_json(json.at("initial"))};
}

Json json_of(const DimensionlessNumbers& numbers) {
  return {{"reynolds_bead", numbers.reynolds_bead},
          {"penetration_depth_over_radius", numbers.penetration_depth_over_radius},
          {"mach", json_or_null(numbers.mach)}};
}

DimensionlessNumbers dimensionless_from(const Json& json) {
  return {json.at("reynolds_bead").get<double>(), json.at("penetration_depth_over_radius").get<double>(),
          value_unless_null<double>(json.at("mach"))};
}

Json json_of(const std::optional<LatticeResolution>& resolution) {
  if (!resolution) return nullptr;
  Json json{{"cells_per_radius", resolution->cells_per_radius},
            {"cell_size", resolution->cell_size},
            {"time_step", resolution->time_step},
            {"relaxation_time", resolution->relaxation_time},
            {"kinematic_viscosity_lattice", resolution->kinematic_viscosity_lattice},
            {"steps_per_cycle", resolution->steps_per_cycle},
            {"bead_boundary", resolution->bead_boundary},
            {"precision", resolution->precision}};
  if (resolution->density_on_lattice) json["density_on_lattice"] = *resolution->density_on_lattice;
  if (resolution->radius_on_lattice) json["radius_on_lattice"] = *resolution->radius_on_lattice;
  if (resolution->angular_softening) json["angular_softening"] = *resolution->angular_softening;
  return json;
}

std::optional<LatticeResolution> resolution_from(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return LatticeResolution{
      .cells_per_radius = json.at("cells_per_radius").get<double>(),
      .cell_size = json.at("cell_size").get<double>(),
      .time_step = json.at("time_step").get<double>(),
      .relaxation_time = json.at("relaxation_time").get<double>(),
      .kinematic_viscosity_lattice = json.at("kinematic_viscosity_lattice").get<double>(),
      .steps_per_cycle = json.at("steps_per_cycle").get<std::int64_t>(),
      .bead_boundary = json.at("bead_boundary").get<std::string>(),
      .density_on_lattice = number_if_any(json, "density_on_lattice"),
      .radius_on_lattice = number_if_any(json, "radius_on_lattice"),
      .angular_softening = number_if_any(json, "angular_softening"),
      .precision = json.at("precision").get<std::string>()};
}

Json json_of(const MobilityRecord& mobility) {
  return {{"time_step", mobility.time_step},
          {"steps_per_cycle", mobility.steps_per_cycle},
          {"tolerance", mobility.tolerance},
          {"products", mobility.products},
          {"cut_off", json_or_null(mobility.cut_off)},
          {"mesh_spacing", json_or_null(mobility.mesh_spacing)},
          {"smallest_gap", json_or_null(mobility.smallest_gap)}};
}

MobilityRecord mobility_from(const Json& json) {
  return {.time_step = json.at("time_step").get<double>(),
          .steps_per_cycle = json.at("steps_per_cycle").get<std::int64_t>(),
          .tolerance = json.at("tolerance").get<double>(),
          .products = json.at("products").get<std::int64_t>(),
          .cut_off = value_unless_null<double>(json.at("cut_off")),
          .mesh_spacing = value_unless_null<double>(json.at("mesh_spacing")),
          .smallest_gap = value_unless_null<double>(json.at("smallest_gap"))};
}

Json json_of(const NearContactRecord& contact) {
  return {{"smallest_gap", json_or_null(contact.smallest_gap)},
          {"lubrication", contact.lubrication},
          {"normal_cut_off", contact.normal_cut_off},
          {"tangential_cut_off", contact.tangential_cut_off},
          {"friction", contact.friction}};
}

NearContactRecord near_contact_from(const Json& json) {
  return {.smallest_gap = value_unless_null<double>(json.at("smallest_gap")),
          .lubrication = json.at("lubrication").get<bool>(),
          .normal_cut_off = json.at("normal_cut_off").get<double>(),
          .tangential_cut_off = json.at("tangential_cut_off").get<double>(),
          .friction = json.at("friction").get<double>()};
}

Json json_of(const RunCost& cost) {
  Json json{{"wall_seconds", cost.wall_seconds},
            {"core_seconds", cost.core_seconds},
            {"ranks", cost.ranks},
            {"cell_updates", json_or_null(cost.cell_updates)},
            {"mlups", json_or_null(cost.mlups)},
            {"peak_memory_bytes", cost.peak_memory_bytes}};
  if (cost.communication) {
    json["communication"] = {{"neighbours", cost.communication->neighbours},
                             {"messages_per_step", cost.communication->messages_per_step},
                             {"bytes_per_step", cost.communication->bytes_per_step}};
  }
  return json;
}

std::optional<CommunicationRecord> communication_from(const Json& cost) {
  if (!cost.contains("communication")) return std::nullopt;
  const Json& json = cost.at("communication");
  return CommunicationRecord{.neighbours = json.at("neighbours").get<int>(),
                             .messages_per_step = json.at("messages_per_step").get<double>(),
                             .bytes_per_step = json.at("bytes_per_step").get<double>()};
}

RunCost cost_from(const Json& json) {
  return {.wall_seconds = json.at("wall_seconds").get<double>(),
          .core_seconds = json.at("core_seconds").get<double>(),
          .ranks = json.at("ranks").get<int>(),
          .cell_updates = value_unless_null<std::int64_t>(json.at("cell_updates")),
          .mlups = value_unless_null<double>(json.at("mlups")),
          .peak_memory_bytes = json.at("peak_memory_bytes").get<std::int64_t>(),
          .communication = communication_from(json)};
}

}  // namespace

std::string name_of(RunStatus status) {
  return name_in(status_names, status);
}

RunRecord run_record_from_json(const Json& document, const std::string& source) {
  validate_json(document, "run", source);
  RunRecord record;
  record.model = document.at("model").get<std::string>();
  record.status = value_in(status_names, document.at("status").get<std::string>());
  record.units = units_from_json(document.at("units"));
  record.domain = domain_from_json(document.at("domain"));
  record.driving_period = document.at("driving").at("period").get<double>();
  record.driving = driving_from(document.at("driving"));
  if (document.contains("swimmers"))
    for (const Json& swimmer : document.at("swimmers")) record.swimmers.push_back(swimmer_from(swimmer));
  if (document.contains("swarm"))
    for (const Json& cycle : document.at("swarm")) record.swarm.push_back(swarm_cycle_from(cycle));
  record.momentum = momentum_from(document.at("momentum"));
  record.mass_relative_change = value_unless_null<double>(document.at("mass_relative_change"));
  record.dimensionless = dimensionless_from(document.at("dimensionless"));
  record.resolution = resolution_from(document.at("resolution"));
  if (document.contains("reason")) record.reason = document.at("reason").get<std::string>();
  if (document.contains("mobility")) record.mobility = mobility_from(document.at("mobility"));
  if (document.contains("near_contact")) record.near_contact = near_contact_from(document.at("near_contact"));
  if (document.contains("cost")) record.cost = cost_from(document.at("cost"));
  record.state_sha256 = value_unless_null<std::string>(document.at("state_sha256"));
  if (document.contains("provenance")) record.provenance = document.at("provenance");
  return record;
}

RunRecord read_run_record(const std::string& path) {
  const std::string source = path == "-" ? "standard input" : path;
  return run_record_from_json(parse_json(read_text(path), source), source);
}

Json run_record_to_json(const RunRecord& record, RecordProvenance provenance) {
  Json swimmers = Json::array();
  for (const SwimmerRecord& swimmer : record.swimmers) swimmers.push_back(json_of(swimmer));
  Json document = {{"schema", "beadswim/run/1"},
                   {"model", record.model},
                   {"status", name_of(record.status)},
                   {"units", units_to_json(record.units)},
                   {"domain", domain_to_json(record.domain)},
                   {"driving", driving_json(record)}};
  if (!record.swimmers.empty()) document["swimmers"] = swimmers;
  if (!record.swarm.empty() || record.swimmers.empty()) {
    Json& swarm = document["swarm"] = Json::array();
    for (const SwarmCycle& cycle : record.swarm) swarm.push_back(json_of(cycle));
  }
  document["momentum"] = json_of(record.momentum);
  document["mass_relative_change"] = json_or_null(record.mass_relative_change);
  document["dimensionless"] = json_of(record.dimensionless);
  document["resolution"] = json_of(record.resolution);
  if (!record.reason.empty()) document["reason"] = record.reason;
  if (record.mobility) document["mobility"] = json_of(*record.mobility);
  if (record.near_contact) document["near_contact"] = json_of(*record.near_contact);
  if (provenance == RecordProvenance::written && record.cost) document["cost"] = json_of(*record.cost);
  document["state_sha256"] = json_or_null(record.state_sha256);
  if (provenance == RecordProvenance::written && record.provenance)
    document["provenance"] = *record.provenance;
  return document;
}

}  // namespace beadswim
