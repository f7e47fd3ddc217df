#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/compare/swarm_statistics.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/io/fields_json.hpp"
#include "beadswim/scene/layout.hpp"

// The run record, in memory and as JSON (schemas/run.schema.json, docs/formats/run-record.md). Quantities are
// in the layout's units.

namespace beadswim {

enum class RunStatus { finished, stopped_speed, stopped_time, stopped_signal, failed };

template <>
inline constexpr auto name_table<RunStatus> =
    std::to_array<NamedValue<RunStatus>>({{RunStatus::finished, "finished"},
                                          {RunStatus::stopped_speed, "stopped-speed"},
                                          {RunStatus::stopped_time, "stopped-time"},
                                          {RunStatus::stopped_signal, "stopped-signal"},
                                          {RunStatus::failed, "failed"}});

struct SwimmerRecord {
  int id = 0;
  std::vector<CycleStatistics> cycles;  ///< whole cycles, in order
  std::optional<double> period;         ///< of its driving, if that is not the base period [time]

  static void visit_fields(auto&& visit, auto& swimmer) {
    visit("id", swimmer.id);
    visit("period", swimmer.period, omitted_if_none);
    visit("cycles", swimmer.cycles);
  }
};

/// A record of more swimmers has statistics of the swarm alone; all swimmers are in the trajectory.
constexpr std::size_t most_swimmers_listed = 64;

/// A swarm, and the momentum of fluid and beads, at the end of a base cycle.
struct SwarmCycle {
  SwarmStatistics statistics;
  Vec3 momentum = Vec3::Zero();

  static void visit_fields(auto&& visit, auto& cycle) {
    beadswim::visit_fields(visit, cycle.statistics);
    visit("momentum", cycle.momentum);
  }
};

/// The driving forces (2.1). Amplitudes and phase are none where the swimmers' differ.
struct DrivingRecord {
  double period = 0;  ///< base period, by which cycles of the run are counted [time]
  std::optional<std::array<double, 2>> amplitude;  ///< A, B [mass length/time^2]
  std::optional<double> phase;                     ///< alpha [radian]

  static void visit_fields(auto&& visit, auto& driving) {
    visit("period", driving.period);
    visit("amplitude", driving.amplitude, omitted_if_none);
    visit("phase", driving.phase, omitted_if_none);
  }

  bool operator==(const DrivingRecord&) const = default;
};

/// Of fluid and beads [mass length/time].
struct MomentumRecord {
  Vec3 total = Vec3::Zero();
  Vec3 initial = Vec3::Zero();

  static void visit_fields(auto&& visit, auto& momentum) {
    visit("total", momentum.total);
    visit("initial", momentum.initial);
  }
};

struct DimensionlessNumbers {
  double reynolds_bead = 0;                  ///< largest bead speed x diameter / nu
  double penetration_depth_over_radius = 0;  ///< sqrt(2 nu/omega) / smallest bead radius
  std::optional<double> mach;                ///< largest bead speed / lattice speed of sound

  static void visit_fields(auto&& visit, auto& numbers) {
    visit("reynolds_bead", numbers.reynolds_bead);
    visit("penetration_depth_over_radius", numbers.penetration_depth_over_radius);
    visit("mach", numbers.mach);
  }
};

/// How a lattice run discretised the scene.
struct LatticeResolution {
  double cells_per_radius = 0;             ///< cells per smallest bead radius
  double cell_size = 0;                    ///< [length]
  double time_step = 0;                    ///< [time]
  double relaxation_time = 0;              ///< as used, in time steps
  double kinematic_viscosity_lattice = 0;  ///< nu in cells^2/step
  std::int64_t steps_per_cycle = 0;
  std::string bead_boundary;                 ///< "staircase", "cli", "mr" or "psm"
  std::optional<double> density_on_lattice;  ///< least of any bead as it moves [fluid density]
  std::optional<double> radius_on_lattice;   ///< of the smallest bead, as the fluid meets it [cell]
  std::optional<double> angular_softening;   ///< least stiffness of an angular spring, in its layout's
  std::string precision;                     ///< "double" or "single"

  static void visit_fields(auto&& visit, auto& resolution) {
    visit("cells_per_radius", resolution.cells_per_radius);
    visit("cell_size", resolution.cell_size);
    visit("time_step", resolution.time_step);
    visit("relaxation_time", resolution.relaxation_time);
    visit("kinematic_viscosity_lattice", resolution.kinematic_viscosity_lattice);
    visit("steps_per_cycle", resolution.steps_per_cycle);
    visit("bead_boundary", resolution.bead_boundary);
    visit("precision", resolution.precision);
    visit("density_on_lattice", resolution.density_on_lattice, omitted_if_none);
    visit("radius_on_lattice", resolution.radius_on_lattice, omitted_if_none);
    visit("angular_softening", resolution.angular_softening, omitted_if_none);
  }
};

/// Beads close to each other, and to periodic images.
struct NearContactRecord {
  std::optional<double> smallest_gap;  ///< none: none came within a cell [length]
  bool lubrication = true;
  double normal_cut_off = 0;      ///< gap below which squeezing is corrected [length]
  double tangential_cut_off = 0;  ///< and sliding [length]
  double friction = 0;            ///< Coulomb's coefficient

  static void visit_fields(auto&& visit, auto& contact) {
    visit("smallest_gap", contact.smallest_gap);
    visit("lubrication", contact.lubrication);
    visit("normal_cut_off", contact.normal_cut_off);
    visit("tangential_cut_off", contact.tangential_cut_off);
    visit("friction", contact.friction);
  }
};

/// How a run without a lattice took its steps and sums.
struct MobilityRecord {
  double time_step = 0;  ///< [time]
  std::int64_t steps_per_cycle = 0;
  double tolerance = 0;                         ///< of bead velocities, relative
  std::int64_t products = 0;                    ///< of mobility and forces
  std::optional<double> cut_off, mesh_spacing;  ///< of Ewald's sum; none where all pairs are summed [length]
  std::optional<double> smallest_gap;           ///< of beads that repelled each other [length]

  static void visit_fields(auto&& visit, auto& mobility) {
    visit("time_step", mobility.time_step);
    visit("steps_per_cycle", mobility.steps_per_cycle);
    visit("tolerance", mobility.tolerance);
    visit("products", mobility.products);
    visit("cut_off", mobility.cut_off);
    visit("mesh_spacing", mobility.mesh_spacing);
    visit("smallest_gap", mobility.smallest_gap);
  }
};

/// What the busiest rank sends to others in a step of the fluid.
struct CommunicationRecord {
  int neighbours = 0;  ///< other ranks that it talks to
  double messages_per_step = 0;
  double bytes_per_step = 0;

  static void visit_fields(auto&& visit, auto& sent) {
    visit("neighbours", sent.neighbours);
    visit("messages_per_step", sent.messages_per_step);
    visit("bytes_per_step", sent.bytes_per_step);
  }
};

struct RunCost {
  double wall_seconds = 0;
  double core_seconds = 0;
  int ranks = 1;
  std::optional<std::int64_t> cell_updates;
  std::optional<double> mlups;  ///< 1e6 cell updates a second
  std::int64_t peak_memory_bytes = 0;
  std::optional<CommunicationRecord> communication;  ///< none in older records

  static void visit_fields(auto&& visit, auto& cost) {
    visit("wall_seconds", cost.wall_seconds);
    visit("core_seconds", cost.core_seconds);
    visit("ranks", cost.ranks);
    visit("cell_updates", cost.cell_updates);
    visit("mlups", cost.mlups);
    visit("peak_memory_bytes", cost.peak_memory_bytes);
    visit("communication", cost.communication, omitted_if_none);
  }
};

/// Optional members are null in JSON where the model has no such thing; cost and provenance may be absent.
struct RunRecord {
  std::string model;
  RunStatus status = RunStatus::finished;
  std::string reason;  ///< why it ended before its time; empty if it did not
  Units units;
  std::optional<Box> domain;  ///< none: unbounded fluid
  DrivingRecord driving;
  std::vector<SwimmerRecord> swimmers;           ///< none if there are more than most_swimmers_listed
  std::optional<std::vector<SwarmCycle>> swarm;  ///< of two swimmers or more
  std::optional<MomentumRecord> momentum;
  std::optional<double> mass_relative_change;
  DimensionlessNumbers dimensionless;
  std::optional<LatticeResolution> resolution;
  std::optional<MobilityRecord> mobility;
  std::optional<NearContactRecord> near_contact;
  std::optional<RunCost> cost;
  std::optional<std::string> state_sha256;  ///< none after a fault
  std::optional<Json> provenance;

  static void visit_fields(auto&& visit, auto& record) {
    visit("model", record.model);
    visit("status", record.status);
    visit("units", record.units);
    visit("domain", record.domain);
    visit("driving", record.driving);
    visit("swimmers", record.swimmers, omitted_if_none);
    visit("swarm", record.swarm, omitted_if_none);
    visit("momentum", record.momentum);
    visit("mass_relative_change", record.mass_relative_change);
    visit("dimensionless", record.dimensionless);
    visit("resolution", record.resolution);
    visit("reason", record.reason, omitted_if_none);
    visit("mobility", record.mobility, omitted_if_none);
    visit("near_contact", record.near_contact, omitted_if_none);
    visit("cost", record.cost, omitted_if_none);
    visit("state_sha256", record.state_sha256);
    visit("provenance", record.provenance, omitted_if_none);
  }
};

/// Whether to write cost and provenance, which differ from run to run.
enum class RecordProvenance { written, left_out };

/// Validates against the schema and converts. `source` names the document in messages. Throws InputError.
RunRecord run_record_from_json(const Json& document, const std::string& source);

/// Reads a file, or stdin for "-". Throws InputError.
RunRecord read_run_record(const std::string& path);

Json run_record_to_json(const RunRecord& record, RecordProvenance provenance);

}  // namespace beadswim
