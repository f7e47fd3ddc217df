#include "mobility_products.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>

#include "beadswim/core/error.hpp"
#include "beadswim/core/median.hpp"
#include "beadswim/mobility/force_moments.hpp"
#include "beadswim/mobility/mobility.hpp"
#include "beadswim/mobility/mobility_root.hpp"
#include "first_ranks.hpp"
#include "particle_mesh.hpp"

namespace beadswim {
namespace {

/// Positions and forces of beads in a cube with edges of length `edge`.
struct Beads {
  std::vector<Vec3> positions, forces;
  double edge = 0;
};

/// Returns beads at random positions in a cube, with a volume of 32^3 per bead, and random forces whose sum
/// is zero.
Beads random_beads(int count) {
  Beads beads{.positions = {}, .forces = {}, .edge = 32 * std::cbrt(count)};
  std::mt19937_64 random(static_cast<unsigned>(count));  // seed = count
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto vector = [&] {
    Vec3 v;
    for (int a = 0; a < 3; ++a) v[a] = uniform(random);
    return v;
  };
  Vec3 sum = Vec3::Zero();
  for (int b = 0; b < count; ++b) {
    beads.positions.push_back(beads.edge * vector());
    beads.forces.push_back(vector());
    sum += beads.forces.back();
  }
  for (Vec3& force : beads.forces) force -= sum / count;
  return beads;
}

/// Returns the resident memory of all ranks together [byte]. Collective.
std::int64_t resident_bytes(const Communicator& communicator) {
  std::ifstream info("/proc/self/statm");
  std::int64_t all = 0, resident = 0;
  info >> all >> resident;
  resident *= sysconf(_SC_PAGE_SIZE);
  MPI_Allreduce(MPI_IN_PLACE, &resident, 1, MPI_INT64_T, MPI_SUM, communicator.get());
  return resident;
}

/// Returns the relative difference |a - reference| / |reference|, with the Euclidean norm over the vectors of
/// all beads.
double relative_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& reference) {
  double difference = 0, size = 0;
  for (std::size_t b = 0; b < a.size(); ++b) {
    difference += (a[b] - reference[b]).squaredNorm();
    size += reference[b].squaredNorm();
  }
  return std::sqrt(difference / size);
}

/// Returns the times of a collective operation, one per round, after one that is not timed [s].
template <class Operation>
std::vector<double> times_of(int rounds, const Communicator& communicator, const Operation& operation) {
  operation();
  std::vector<double> seconds;
  for (int n = 0; n < rounds; ++n) {
    MPI_Barrier(communicator.get());
    const double start = MPI_Wtime();
    operation();
    seconds.push_back(MPI_Wtime() - start);
  }
  return seconds;
}

/// Returns the median time of one sum of a product on the mesh alone [s].
double mesh_seconds(const MobilityScene& scene, const EwaldPlan& plan, const Beads& beads, int rounds,
                    const Communicator& communicator) {
  const std::size_t count = beads.positions.size(), each = 3 * derivative_count(scene.moment_order);
  std::vector<double> sources(each * count, 1.0), flows(each * count);
  const ImagedSpheres spheres{.order = scene.moment_order,
                              .viscosity = scene.viscosity,
                              .radii = scene.radii,
                              .lengths = scene.domain.box->lengths};
  ParticleMesh mesh(plan, spheres, scene.memory, {}, Receivers::spheres, communicator);
  return median(times_of(rounds, communicator, [&] {
    mesh.set_sources(beads.positions, bounding_box(beads.positions));
    mesh.set_receivers(beads.positions);
    mesh.add_flows(sources, FlowPart::forces, flows);
  }));
}

/// Times one mobility product. Evaluates its error relative to a product with 1/1000 of the tolerance.
ProductRow measure(const ProductRequest& request, int count, Surroundings surroundings,
                   const Communicator& communicator) {
  const int max_beads_for_error = request.multipole_order == 0 ? 100000 : 5000;
  constexpr double min_tolerance_for_error = 1e-9, radius = 6;
  bool is_on_mesh = false;
  const Beads beads = random_beads(count);
  MobilityScene scene{.model = request.is_unsteady ? MobilityModel::unsteady : MobilityModel::multipole,
                      .viscosity = 1.0 / 3,
                      .domain = {},
                      .radii = std::vector<double>(count, radius),
                      .tolerance = request.tolerance,
                      .moment_order = request.multipole_order};
  if (surroundings == Surroundings::periodic)
    scene.domain.box = Box{{beads.edge, beads.edge, beads.edge}, {}};
  if (request.is_unsteady)
    scene.memory = FluidMemory{.density = 1,
                               .step = 20,
                               .spacing = max_memory_spacing[request.multipole_order] * radius,
                               .has_reynolds_stress = true};
  ProductRow row{.beads = count,
                 .surroundings = surroundings,
                 .ranks = communicator.size(),
                 .tolerance = request.tolerance,
                 .multipole_order = request.multipole_order};
  std::vector<Vec3> velocities(count), reference(count);
  {
    const std::int64_t before = resident_bytes(communicator);
    Mobility product(scene, beads.positions, communicator);
    is_on_mesh = product.plan().has_value();
    const std::vector<double> seconds = times_of(request.rounds, communicator, [&] {
      product.set_positions(beads.positions);
      const ProductWork work = product.apply(beads.forces, velocities);
      row.iterations = static_cast<int>(work.iterations);
    });
    if (request.has_noise) {
      constexpr double noise_tolerance = 1e-3;
      MobilityRoot root(scene, beads.positions, noise_tolerance, product, communicator);
      std::uint64_t seed = 0;
      row.noise_seconds =
          median(times_of(request.rounds, communicator, [&] { root.at(beads.positions, ++seed); }));
    }
    row.memory_bytes = resident_bytes(communicator) - before;
    row.seconds = median(seconds);
    row.seconds_best = *std::ranges::min_element(seconds);
    if (request.is_unsteady) {
      row.mesh_seconds = mesh_seconds(scene, *product.plan(), beads, request.rounds, communicator);
      row.end_of_step_seconds = median(
          times_of(request.rounds, communicator, [&] { product.end_step(product.moments(), Vec3::Zero()); }));
    }
  }
  if (is_on_mesh && count <= max_beads_for_error && request.tolerance >= min_tolerance_for_error) {
    scene.tolerance = request.tolerance / 1000;
    Mobility(scene, beads.positions, communicator).apply(beads.forces, reference);
    row.error = relative_difference(velocities, reference);
  }
  return row;
}

}  // namespace

std::vector<ProductRow> measure_products(const ProductRequest& request, const Communicator& world) {
  std::vector<ProductRow> rows;
  for (const int count : request.beads) {
    for (const Surroundings surroundings : all_values<Surroundings>) {
      if (request.is_unsteady && surroundings != Surroundings::periodic) continue;
      for (int ranks = 1; ranks <= world.size(); ranks += std::max(1, world.size() - 1)) {
        if (world.is_root())
          print_to_stderr(fmt::format(
              "beadswim-bench: measuring the mobility product of {} beads on {} ranks\n", count, ranks));
        run_on_first_ranks(ranks, world, [&](const Communicator& communicator) {
          rows.push_back(measure(request, count, surroundings, communicator));
        });
      }
    }
  }
  return rows;
}

}  // namespace beadswim
