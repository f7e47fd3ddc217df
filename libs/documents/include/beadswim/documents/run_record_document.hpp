#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/compare/diffusion.hpp"
#include "beadswim/compare/run_uncertainty.hpp"
#include "beadswim/compare/swarm_statistics.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/io/fields_json.hpp"
#include "beadswim/scene/layout.hpp"

// The run record in memory and as JSON (schemas/run.schema.json, docs/formats/run-record.md). All quantities
// are in the units of the layout.

namespace beadswim {

/// State in which a run ended.
enum class RunStatus { finished, stopped_speed, stopped_time, stopped_signal, failed };

template <>
inline constexpr auto name_table<RunStatus> =
    std::to_array<NamedValue<RunStatus>>({{RunStatus::finished, "finished"},
                                          {RunStatus::stopped_speed, "stopped-speed"},
                                          {RunStatus::stopped_time, "stopped-time"},
                                          {RunStatus::stopped_signal, "stopped-signal"},
                                          {RunStatus::failed, "failed"}});

/// Cycle statistics of one swimmer.
struct SwimmerRecord {
  int id = 0;
  std::vector<CycleStatistics> cycles;                 ///< complete cycles, in order
  std::optional<double> period;                        ///< driving period [time]; nullopt: the base period
  std::optional<SwimmerUncertainty> uncertainty = {};  ///< of the last cycle; nullopt if unknown

  BEADSWIM_FIELDS(id, (period, omitted_if_none), cycles, (uncertainty, omitted_if_none))
};

/// Largest number of swimmers for which a run record contains statistics of each swimmer, and a run record or
/// a prediction contains the scene. The record of a larger swarm contains only averages over the swarm; the
/// trajectory file always contains all swimmers.
constexpr std::size_t max_swimmers_listed = 64;

/// Statistics of the swarm, and momentum of fluid and beads [mass length/time], at the end of a base cycle.
struct SwarmCycle {
  SwarmStatistics statistics;
  Vec3 momentum = Vec3::Zero();

  static void visit_fields(auto&& visit, auto& cycle) {
    beadswim::visit_fields(visit, cycle.statistics);
    visit("momentum", cycle.momentum);
  }
};

/// Driving of the swimmers. Amplitudes and phase are nullopt if they differ between swimmers.
struct DrivingRecord {
  double period = 0;                               ///< base period: duration of one cycle of the run [time]
  std::optional<std::array<double, 2>> amplitude;  ///< A, B of beads 1 and 3 [mass length/time^2]
  std::optional<double> phase;                     ///< driving phase alpha [radian]

  BEADSWIM_FIELDS(period, (amplitude, omitted_if_none), (phase, omitted_if_none))

  bool operator==(const DrivingRecord&) const = default;
};

/// Momentum of fluid and beads at the end and at the start of the run [mass length/time].
struct MomentumRecord {
  Vec3 total = Vec3::Zero();
  Vec3 initial = Vec3::Zero();

  BEADSWIM_FIELDS(total, initial)
};

/// Dimensionless numbers of the run. nu: kinematic viscosity; omega: angular frequency of the base period.
struct DimensionlessNumbers {
  double reynolds_bead = 0;  ///< largest bead speed relative to background flow x diameter / nu
  double penetration_depth_over_radius = 0;  ///< sqrt(2 nu/omega) / smallest bead radius
  std::optional<double> mach;                ///< largest bead speed in the run / lattice speed of sound

  BEADSWIM_FIELDS(reynolds_bead, penetration_depth_over_radius, mach)
};

/// A box of cells.
struct CellBoxRecord {
  Vec3 lower = Vec3::Zero(), upper = Vec3::Zero();  ///< corners [length]

  BEADSWIM_FIELDS(lower, upper)
};

/// A level of cells at the end of a lattice run.
struct LevelRecord {
  double cell = 0;                   ///< edge of a cell [length]
  std::vector<CellBoxRecord> boxes;  ///< boxes that the level fills
  std::int64_t cells = 0;            ///< number of cells

  BEADSWIM_FIELDS(cell, boxes, cells)
};

/// Discretisation of the scene in a lattice run. All quantities but `levels` are those of the finest cells.
struct LatticeResolution {
  double cells_per_radius = 0;               ///< cells per smallest bead radius
  double cell_size = 0;                      ///< edge of a cell [length]
  double time_step = 0;                      ///< [time]
  double relaxation_time = 0;                ///< tau, as used in the run [step]
  double kinematic_viscosity_lattice = 0;    ///< nu [cell^2/step]
  std::int64_t steps_per_cycle = 0;          ///< time steps per base cycle
  std::string bead_boundary;                 ///< "staircase", "cli", "mr" or "psm"
  std::optional<double> density_on_lattice;  ///< smallest bead density on the lattice [fluid density]
  std::optional<double> radius_on_lattice;   ///< radius of the smallest bead on the lattice [cell]
  std::optional<double> angular_softening;   ///< smallest ratio of angular stiffness to that of the layout
  std::string precision;                     ///< "double" or "single"
  std::vector<LevelRecord> levels;           ///< coarsest first

  BEADSWIM_FIELDS(cells_per_radius, cell_size, time_step, relaxation_time, kinematic_viscosity_lattice,
                  steps_per_cycle, bead_boundary, precision, (density_on_lattice, omitted_if_none),
                  (radius_on_lattice, omitted_if_none), (angular_softening, omitted_if_none), levels)
};

/// Lubrication and contact of beads that are close to each other or to images of beads.
struct NearContactRecord {
  std::optional<double> smallest_gap;  ///< nullopt if no pair came within one cell [length]
  bool lubrication = true;             ///< true: the lubrication correction is on
  double normal_cut_off = 0;           ///< gap below which lubrication corrects normal motion [length]
  double tangential_cut_off = 0;       ///< gap below which lubrication corrects tangential motion [length]
  double friction = 0;                 ///< coefficient of Coulomb friction

  BEADSWIM_FIELDS(smallest_gap, lubrication, normal_cut_off, tangential_cut_off, friction)
};

/// Discretisation and work of a run with a mobility model.
struct MobilityRecord {
  double time_step = 0;  ///< [time]
  std::int64_t steps_per_cycle = 0;
  double tolerance = 0;                 ///< relative error of bead velocities
  std::int64_t products = 0;            ///< number of evaluations of mobility times forces
  std::optional<int> multipole_order;   ///< highest moment of the force on each bead; nullopt: other models
  std::optional<bool> reynolds_stress;  ///< only with the model unsteady
  std::optional<std::int64_t> iterations;       ///< number of iterations of all products
  std::optional<double> residual;               ///< largest residual of a product
  std::optional<double> cut_off, mesh_spacing;  ///< parameters of the Ewald sum [length]; nullopt: direct sum
  std::optional<double> smallest_gap;           ///< smallest gap that caused repulsion [length]

  BEADSWIM_FIELDS(time_step, steps_per_cycle, tolerance, products, (multipole_order, omitted_if_none),
                  (reynolds_stress, omitted_if_none), (iterations, omitted_if_none),
                  (residual, omitted_if_none), cut_off, mesh_spacing, smallest_gap)
};

/// Thermal noise of a run with a mobility model.
struct ThermalRecord {
  double thermal_energy = 0;   ///< kT [mass length^2/time^2]
  std::int64_t seed = 0;       ///< of the random numbers
  double noise_tolerance = 0;  ///< accepted relative error of the noise in a step
  double noise_error = 0;      ///< largest relative error of the noise in any step
  DiffusionStatistics diffusion{};  ///< of the ends of base cycles

  static void visit_fields(auto&& visit, auto& record) {
    visit("thermal_energy", record.thermal_energy);
    visit("seed", record.seed);
    visit("noise_tolerance", record.noise_tolerance);
    visit("noise_error", record.noise_error);
    beadswim::visit_fields(visit, record.diffusion);
  }
};

/// Communication of a rank per lattice step. Each number is the maximum over all ranks.
struct CommunicationRecord {
  int neighbours = 0;  ///< number of ranks to which a rank sends messages
  double messages_per_step = 0;
  double bytes_per_step = 0;

  BEADSWIM_FIELDS(neighbours, messages_per_step, bytes_per_step)
};

/// Cost of a run, including earlier runs that it continues from a checkpoint.
struct RunCost {
  double wall_seconds = 0;
  double core_seconds = 0;
  double cycles = 0;  ///< base cycles that the run has completed
  int ranks = 1;
  std::optional<std::int64_t> cell_updates;
  std::optional<double> mlups;  ///< 10^6 cell updates per second of wall time
  std::int64_t peak_memory_bytes = 0;
  std::optional<CommunicationRecord> communication;  ///< nullopt without a lattice, or if unknown

  BEADSWIM_FIELDS(wall_seconds, core_seconds, cycles, ranks, cell_updates, mlups, peak_memory_bytes,
                  (communication, omitted_if_none))
};

/// A warning about a run: a code for programs, and a message for users.
struct RunWarning {
  std::string code;
  std::string message;

  BEADSWIM_FIELDS(code, message)
};

/// The run record. In JSON, a member that is visited with omitted_if_none is absent if it has no value; any
/// other optional member is then null. The scene is converted by scene_to_json().
struct RunRecord {
  std::string model;
  RunStatus status = RunStatus::finished;
  std::string reason;  ///< why the run stopped early; empty if it finished
  Units units;
  Domain domain;
  std::optional<BackgroundFlow> flow;  ///< nullopt: none
  std::optional<Vec3> body_force;      ///< nullopt: none
  DrivingRecord driving;
  std::vector<SwimmerRecord> swimmers;           ///< empty for more than max_swimmers_listed swimmers
  std::optional<std::vector<SwarmCycle>> swarm;  ///< nullopt for a single swimmer
  std::optional<MomentumRecord> momentum;
  std::optional<double> mass_relative_change;
  DimensionlessNumbers dimensionless;
  std::optional<LatticeResolution> resolution;
  std::optional<MobilityRecord> mobility;
  std::optional<ThermalRecord> thermal;  ///< nullopt: without noise
  std::optional<NearContactRecord> near_contact;
  std::optional<ErrorEstimate> expected_error;        ///< nullopt: unknown
  std::optional<std::vector<RunWarning>> warnings;    ///< nullopt: unknown
  std::optional<RunCost> cost;
  std::optional<std::string> state_sha256;    ///< nullopt after a fault
  std::optional<Json> study;                  ///< study of the layout (layout_document.hpp); nullopt: none
  std::optional<std::string> request_sha256;  ///< nullopt: not of a stream
  std::optional<Json> provenance;
  std::optional<Layout> scene;  ///< nullopt for more than max_swimmers_listed swimmers, or if unknown

  BEADSWIM_FIELDS(model, status, units, domain, (flow, omitted_if_none), (body_force, omitted_if_none),
                  driving, (swimmers, omitted_if_none), (swarm, omitted_if_none), momentum,
                  mass_relative_change, dimensionless, resolution, (reason, omitted_if_none),
                  (mobility, omitted_if_none), (thermal, omitted_if_none), (near_contact, omitted_if_none),
                  (expected_error, omitted_if_none), warnings, (cost, omitted_if_none), state_sha256,
                  (study, omitted_if_none), (request_sha256, omitted_if_none), (provenance, omitted_if_none))
};

/// Sets what the record states of the scene of a run: units, domain, flow, body force and driving.
void set_surroundings(const Layout& layout, double base_period, RunRecord& record);

/// Selects whether cost and provenance are written. They differ between runs with identical results.
enum class RecordProvenance { written, left_out };

/// Converts JSON after validation against the schema. `source`: name of the document in messages. Throws
/// InputError.
RunRecord run_record_from_json(const Json& document, const std::string& source);

/// Returns the record as JSON.
Json run_record_to_json(const RunRecord& record, RecordProvenance provenance);

}  // namespace beadswim
