#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/documents/swimming_document.hpp"
#include "beadswim/documents/trajectory_file.hpp"
#include "beadswim/figure/swimmer_sketch.hpp"
#include "beadswim/scene/swimmer_parameters.hpp"
#include "beadswim/scene/units.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"
#include "kinds.hpp"
#include "plot_labels.hpp"

namespace beadswim {
namespace {

/// Returns the swimmer with this id, or the first swimmer if `id` is nullopt. Throws InputError if no swimmer
/// has this id.
const Swimmer& find_swimmer(const Layout& layout, std::optional<int> id, const std::string& source) {
  std::vector<int> ids;
  for (const Swimmer& swimmer : layout.swimmers) ids.push_back(swimmer.id);
  return layout.swimmers[id ? swimmer_with_id(*id, ids, "--swimmers", source) : 0];
}

/// Returns the parameters of a swimmer. Throws InputError if it is not the paper's swimmer.
ThreeBeadSwimmer paper_swimmer(const Layout& layout, const Swimmer& swimmer, const std::string& source) {
  if (const auto three = three_bead_form(layout.resolved_type(swimmer))) return *three;
  throw InputError(source,
                   "swimmer {} is not the paper's (three beads in a line, two springs, two driving forces), "
                   "the only one that has a sketch; draw its beads and bonds with beadswim-plot swarm",
                   swimmer.id);
}

/// Returns one label for each value: "λ = 4" if all values are equal, otherwise "λ₁ = 4" with the number of
/// the bead or arm. `unit`: text after the value.
template <std::size_t Count>
std::array<std::string, Count> labels(const std::string& symbol, const std::array<double, Count>& values,
                                      const std::string& unit) {
  constexpr std::array subscripts{"₁", "₂", "₃"};
  const bool alike = std::ranges::count(values, values[0]) == static_cast<long>(Count);
  std::array<std::string, Count> labels;
  for (std::size_t i = 0; i < Count; ++i)
    labels[i] = fmt::format("{}{} = {:.4g}{}", symbol, alike ? "" : subscripts[i], values[i], unit);
  return labels;
}

/// Returns the formulas of the driving forces on the three beads: equation (2.1) of the paper (Pickl et al.
/// 2017), with the phase offset φ.
std::array<std::string, 3> force_labels(const ThreeBeadDriving& driving) {
  const std::string offset = driving.phase_offset == 0 ? "" : " + φ";
  const std::string first = offset.empty() ? "A sin ωt" : fmt::format("A sin(ωt{})", offset);
  return {"F₁ = " + first, "F₂ = −F₁ − F₃", fmt::format("F₃ = B sin(ωt + α{})", offset)};
}

/// Returns the angle between the swimmer's axis and the driving forces [rad]. It differs from 0 only in the
/// lab frame, in which the forces are along the x axis.
double force_angle(const Swimmer& swimmer, const ThreeBeadDriving& driving) {
  if (driving.frame != DrivingFrame::lab) return 0;
  return std::acos(std::clamp(swimmer.axis.x(), -1.0, 1.0));
}

/// Returns a text with the parameters of beads and springs that the labels of the sketch do not show.
std::string unlabelled_parameters(const ThreeBeadSwimmer& type) {
  std::vector<double> densities;
  for (const auto& bead : type.beads) densities.push_back(bead.density);
  return fmt::format("Bead density {}, KA = {:.4g}", range_text(densities, 4), type.angular_stiffness);
}

std::string fluid_text(const Layout& layout) {
  std::string note =
      fmt::format("Fluid: ρ = {:.4g}, ν = {:.4g}; ", layout.fluid.density, layout.fluid.kinematic_viscosity);
  return note + in_words(layout.domain);
}

SwimmerSketch swimmer_figure(const std::vector<std::string>& files, std::optional<int> id) {
  const std::string file = only_file(files, "a swimmer is drawn from one layout");
  const Layout layout = read_layout(file).layout;
  const Swimmer& swimmer = find_swimmer(layout, id, source_name(file));
  const ThreeBeadSwimmer type = paper_swimmer(layout, swimmer, source_name(file));
  const Units& units = layout.units;
  const std::string length = units.lattice ? "" : " " + units.length.name;
  const std::string friction = units.lattice ? "" : fmt::format(" {}/{}", units.mass.name, units.time.name);
  const std::string stiffness = units.lattice ? "" : friction + "²";
  const auto& [one, two, three] = type.beads;
  const auto& [first, second] = type.springs;
  SwimmerSketch sketch{.title = fmt::format("Swimmer {} of type {}", swimmer.id, swimmer.type),
                       .radii = {one.radius, two.radius, three.radius},
                       .rest_lengths = {first.rest_length, second.rest_length},
                       .force_labels = force_labels(type.driving),
                       .spring_labels = labels<2>("k", {first.stiffness, second.stiffness}, stiffness),
                       .dashpot_labels = labels<2>("c", {first.damping, second.damping}, friction),
                       .force_angle = force_angle(swimmer, type.driving)};
  sketch.radius_labels = labels("λ", sketch.radii, length);
  sketch.length_unit = length_unit(units);
  sketch.length_labels = labels("l", sketch.rest_lengths, length);
  for (std::size_t arm = 0; arm < 2; ++arm)
    if (type.springs[arm].damping == 0) sketch.dashpot_labels[arm].clear();
  sketch.notes = {{.text = unlabelled_parameters(type)},
                  {.text = driving_parameters(drives(type.driving)) + "; ω = 2π/T"},
                  {.text = fluid_text(layout)},
                  {.text = "At rest, to scale, in " + unit_names(units)},
                  {.text = "Arm 1 trails, arm 2 leads."}};
  return sketch;
}

}  // namespace

DrawFigure add_swimmer_flags(CLI::App& command) {
  const auto ids = std::make_shared<std::vector<int>>();
  add_swimmers(command, *ids, "ID", "the layout's first", "Id of the swimmer to draw");
  return [ids](const PlotFiles& files) {
    if (ids->size() > 1)
      throw InputError("--swimmers", "{} ids are given, but a sketch shows one swimmer; give one id",
                       ids->size());
    const auto id = ids->empty() ? std::nullopt : std::optional(ids->front());
    return draw(swimmer_figure(files.inputs, id));
  };
}

}  // namespace beadswim
