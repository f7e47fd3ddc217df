#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/compare/swarm_statistics.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/scene/layout.hpp"

// The run record, in memory and as JSON (schemas/run.schema.json, docs/formats/run-record.md). Quantities are
// in the layout's units.

namespace beadswim {

enum class RunStatus { finished, stopped_speed, stopped_time, stopped_signal, failed };

struct SwimmerRecord {
  int id = 0;
  std::vector<CycleStatistics> cycles;  ///< whole cycles, in order
  std::optional<double> period;         ///< of its driving, if that is not the base period [time]
};

/// A record of more swimmers has statistics of the swarm alone; all swimmers are in the trajectory.
constexpr std::size_t most_swimmers_listed = 64;

/// A swarm, and the momentum of fluid and beads, at the end of a base cycle.
struct SwarmCycle {
  SwarmStatistics statistics;
  Vec3 momentum = Vec3::Zero();
};

/// Of the driving forces (2.1).
struct DrivingRecord {
  std::array<double, 2> amplitude{};  ///< A, B [mass length/time^2]
  double phase = 0;                   ///< alpha [radian]

  bool operator==(const DrivingRecord&) const = default;
};

/// Of fluid and beads [mass length/time].
struct MomentumRecord {
  Vec3 total = Vec3::Zero();
  Vec3 initial = Vec3::Zero();
};

struct DimensionlessNumbers {
  double reynolds_bead = 0;                  ///< largest bead speed x diameter / nu
  double penetration_depth_over_radius = 0;  ///< sqrt(2 nu/omega) / smallest bead radius
  std::optional<double> mach;                ///< largest bead speed / lattice speed of sound
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
};

/// Beads close to each other, and to periodic images.
struct NearContactRecord {
  std::optional<double> smallest_gap;  ///< none: none came within a cell [length]
  bool lubrication = true;
  double normal_cut_off = 0;      ///< gap below which squeezing is corrected [length]
  double tangential_cut_off = 0;  ///< and sliding [length]
  double friction = 0;            ///< Coulomb's coefficient
};

/// How a run without a lattice took its steps and sums.
struct MobilityRecord {
  double time_step = 0;  ///< [time]
  std::int64_t steps_per_cycle = 0;
  double tolerance = 0;                         ///< of bead velocities, relative
  std::int64_t products = 0;                    ///< of mobility and forces
  std::optional<double> cut_off, mesh_spacing;  ///< of Ewald's sum; none where all pairs are summed [length]
  std::optional<double> smallest_gap;           ///< of beads that repelled each other [length]
};

/// What the busiest rank sends to others in a step of the fluid.
struct CommunicationRecord {
  int neighbours = 0;  ///< other ranks that it talks to
  double messages_per_step = 0;
  double bytes_per_step = 0;
};

struct RunCost {
  double wall_seconds = 0;
  double core_seconds = 0;
  int ranks = 1;
  std::optional<std::int64_t> cell_updates;
  std::optional<double> mlups;  ///< 1e6 cell updates a second
  std::int64_t peak_memory_bytes = 0;
  std::optional<CommunicationRecord> communication;  ///< none in older records
};

/// Optional members are null in JSON where the model has no such thing; cost and provenance may be absent.
struct RunRecord {
  std::string model;
  RunStatus status = RunStatus::finished;
  std::string reason;  ///< why it ended before its time; empty if it did not
  Units units;
  std::optional<Box> domain;             ///< none: unbounded fluid
  double driving_period = 0;             ///< base period, by which cycles of the run are counted
  std::optional<DrivingRecord> driving;  ///< none where the swimmers' differ
  std::vector<SwimmerRecord> swimmers;   ///< none if there are more than most_swimmers_listed
  std::vector<SwarmCycle> swarm;         ///< of two swimmers or more
  std::optional<MomentumRecord> momentum;
  std::optional<double> mass_relative_change;
  DimensionlessNumbers dimensionless;
  std::optional<LatticeResolution> resolution;
  std::optional<MobilityRecord> mobility;
  std::optional<NearContactRecord> near_contact;
  std::optional<RunCost> cost;
  std::optional<std::string> state_sha256;  ///< none after a fault
  std::optional<Json> provenance;
};

/// Whether to write cost and provenance, which differ from run to run.
enum class RecordProvenance { written, left_out };

std::string name_of(RunStatus status);  ///< "stopped-time", ...

/// Validates against the schema and converts. `source` names the document in messages. Throws InputError.
RunRecord run_record_from_json(const Json& document, const std::string& source);

/// Reads a file, or stdin for "-". Throws InputError.
RunRecord read_run_record(const std::string& path);

Json run_record_to_json(const RunRecord& record, RecordProvenance provenance);

}  // namespace beadswim
