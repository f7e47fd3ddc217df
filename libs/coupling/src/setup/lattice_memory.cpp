#include "beadswim/coupling/lattice_memory.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <numbers>

#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/coupling/bead_links.hpp"
#include "beadswim/coupling/refinement.hpp"
#include "beadswim/lattice/populations.hpp"

namespace beadswim {

double installed_bytes() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

double bead_surface(const CoupledScene& scene) {
  double area = 0;
  for (const PlacedSwimmer& swimmer : scene.swimmers) {
    for (const Bead& bead : scene.type_of(swimmer).beads)
      area += 4 * std::numbers::pi * bead.radius * bead.radius;
  }
  return area;
}

double lattice_bytes(const CoupledScene& scene) {
  double bytes = cells_on_levels(scene.all_levels());  // one byte per cell: coverage by beads
  for (const Block& level : scene.all_levels())
    bytes += static_cast<double>(
        Populations::bytes_of(level.size, scene.precision, halo_content(scene.bead_boundary)));
  // Links per unit of surface area [1/cell^2]: sum of |c_i.n| over one direction of each opposite pair,
  // averaged over the surface normals n.
  constexpr double links_of_area = 5.74;
  constexpr double lists = 1.2;  // memory of links, rows and segments, divided by the memory of links
  return bytes + lists * sizeof(BeadLink) * links_of_area * bead_surface(scene);
}

void require_memory(const CoupledScene& scene, const Communicator& communicator) {
  const double needed = lattice_bytes(scene) / communicator.size() * count_ranks_on_node(communicator);
  double lack = needed - installed_bytes();
  MPI_Allreduce(MPI_IN_PLACE, &lack, 1, MPI_DOUBLE, MPI_MAX, communicator.get());
  if (lack <= 0) return;
  const bool has_walls =
      std::ranges::count(scene.boundary, Boundary::no_slip) > 0;  // mobility models have no no-slip walls
  const std::string model = has_walls ? "" : fmt::format(", {} rpy (without cells)", Setting::model);
  const std::string precision =
      scene.precision == Precision::fp64 ? fmt::format("{} single, ", Setting::precision) : "";
  throw InputError(
      "box",
      "the {:.3g} lattice cells need {:.3g} GB of memory, {:.3g} GB more than this machine has; use {}fewer "
      "{}, a smaller {} in the layout (beadswim-layout reduce, if the scene repeats){} or more machines",
      cells_on_levels(scene.all_levels()), 1e-9 * lattice_bytes(scene), 1e-9 * lack, precision,
      Setting::cells_per_radius, Setting::box, model);
}

}  // namespace beadswim
