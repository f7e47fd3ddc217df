#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/io/fields_json.hpp"
#include "beadswim/scene/units.hpp"
#include "beadswim/theory/scene_numbers.hpp"
#include "beadswim/tools/program.hpp"
#include "commands.hpp"
#include "layout_output.hpp"

namespace beadswim {
namespace {

std::string short_list(std::span<const double> values) {
  constexpr std::size_t max_values = 6;
  if (values.size() <= max_values) return joined(values, ", ", "{:.4g}");
  const auto [least, most] = std::ranges::minmax(values);
  return fmt::format("{:.4g} to {:.4g}", least, most);
}

std::string row(const std::string& name, const std::string& value) {
  return fmt::format("  {:<58} {}\n", name, value);
}

/// Return no row for a number that is not known, and for an empty list.
std::string row(const std::string& name, const std::optional<double>& value) {
  return value ? row(name, fmt::format("{:.4g}", *value)) : "";
}
std::string row(const std::string& name, std::span<const double> values) {
  return values.empty() ? "" : row(name, short_list(values));
}

std::string table_of(const std::string& name, const TypeNumbers& numbers) {
  const char* arms = numbers.arm_gaps.size() == 2 ? "arms 1, 2" : "bonds";
  const auto& box = numbers.box_over_swimmer_length;
  return fmt::format("type {}\n", name) + row("driving phase alpha [rad]", numbers.phase) +
         row("Re = 2 lambda v/nu, fastest bead", numbers.reynolds_bead) +
         row("penetration depth delta = sqrt(2 nu/omega)", numbers.penetration_depth) +
         row("lambda/delta", numbers.radius_over_penetration_depth) +
         row(fmt::format("l/lambda, {}", arms), numbers.arm_over_radius) +
         row(fmt::format("gamma omega/k, {}", arms), numbers.drag_over_spring) +
         row("predicted arm amplitudes d1, d2 (first order, Rotne-Prager)", numbers.arm_amplitudes) +
         row("gaps between an arm's beads at rest", numbers.arm_gaps) +
         row("displacement of beads at the start from \"at\"", numbers.start_displacement) +
         row("box/swimmer length, x, y, z", box ? std::span<const double>(*box) : std::span<const double>()) +
         row("strain of the background flow per period, G T", numbers.strain_per_period) +
         row("Re of the shear = G lambda^2/nu", numbers.shear_reynolds) +
         row(fmt::format("kT/(k l^2), {}", arms), numbers.thermal_over_spring) +
         row("momentum time lambda^2/nu over the period", numbers.momentum_time_over_period) +
         row("Peclet number v L/D (second order, Rotne-Prager)", numbers.peclet);
}

std::string table_of(const ResolutionNumbers& numbers) {
  std::string text = "resolution hint\n" + row("cell", numbers.cell) + row("time step", numbers.time_step);
  for (const auto& [name, steps] : numbers.steps_per_period)
    text += row(fmt::format("steps a period, type {}", name), steps);
  return text + row("cells in the box", numbers.cells_in_box) +
         row("Mach number of the fastest bead", numbers.mach);
}

std::string table_of(const Layout& layout, const SceneNumbers& numbers) {
  const double gap = numbers.smallest_gap;
  std::string text = "scene\n" + row("swimmers", std::to_string(layout.swimmers.size())) +
                     row("units", layout.units.lattice ? "lattice" : unit_names(layout.units)) +
                     row("smallest gap between surfaces (beads, images, walls)",
                         std::isfinite(gap) ? fmt::format("{:.4g}", gap) : "none");
  text += row("smallest height over the wall/radius of the bead", numbers.smallest_relative_height);
  for (const auto& [name, of_type] : numbers.types) text += table_of(name, of_type);
  if (numbers.resolution) text += table_of(*numbers.resolution);
  return text;
}

Json json_of(const LayoutDocument& document, const SceneNumbers& numbers) {
  Json json{{"schema", "beadswim/layout-check/1"}, {"swimmers", document.layout.swimmers.size()}};
  add_fields(json, numbers);
  if (!document.study.is_null()) json["study"] = document.study;
  return json;
}

/// Returns the line above the table of a layout of a stream.
std::string heading(const StreamMember& member, const Json& study) {
  std::string values;
  for (const auto& [name, value] : study.items()) values += fmt::format(", {} = {}", name, value.dump());
  return fmt::format("layout {}{}\n", member.number, values);
}

/// Prints a warning for each arm whose predicted amplitude is not smaller than the gap between its two beads.
/// Beads with such an amplitude would collide, but the first-order prediction does not include collisions.
void warn_of_collisions(const SceneNumbers& numbers) {
  for (const auto& [name, type] : numbers.types) {
    for (std::size_t arm = 0; arm < type.arm_amplitudes.size(); ++arm) {
      if (type.arm_amplitudes[arm] < type.arm_gaps[arm]) continue;
      fmt::print(stderr,
                 "beadswim-layout: warning: /types/{}: the predicted amplitude {:.4g} of arm {} exceeds the "
                 "gap {:.4g} between its two beads, so these beads will collide; lower the driving "
                 "amplitude, or raise stiffness or damping\n",
                 name, type.arm_amplitudes[arm], arm + 1, type.arm_gaps[arm]);
    }
  }
}

struct CheckFlags {
  std::vector<std::string> files{"-"};
  bool json = false;
};

void check(const CheckFlags& flags) {
  DocumentStream stream(flags.files);
  const bool is_lines = !stream.is_single() || stream.is_lines();
  std::string faults;
  while (const auto member = stream.next()) {
    try {
      const LayoutDocument document = layout_of(*member);
      const SceneNumbers numbers = scene_numbers(document.layout);
      warn_of_collisions(numbers);
      warn_of_fixed_forces(document.layout);
      if (flags.json) {
        const Json json = json_of(document, numbers);
        write_text("-", is_lines ? dump_json_line(json) : dump_json(json));
      } else {
        if (!stream.is_single()) write_text("-", heading(*member, document.study));
        write_text("-", table_of(document.layout, numbers));
      }
    } catch (const InputError& error) {
      faults += (faults.empty() ? "" : "\n") + std::string(error.what());
    }
  }
  if (!faults.empty()) throw InputError(faults);
}

}  // namespace

Command add_check_command(CLI::App& program) {
  const auto flags = std::make_shared<CheckFlags>();
  CLI::App* const command = program.add_subcommand(
      "check",
      "Checks a layout and prints its dimensionless numbers. If the layout is invalid, prints each fault "
      "with its place in the file (JSON pointer) and ends with exit status 2.");
  add_layout_files(*command, flags->files);
  command->add_flag("--json", flags->json, "Print the numbers as JSON instead of a table.");
  set_footer(*command,
             {"beadswim-layout check layout.json",
              "beadswim-layout swimmer --preset paper-single --unbounded | beadswim-layout check --json"},
             "formats/layout-check.md");
  return {command, [flags] { check(*flags); }};
}

}  // namespace beadswim
