#include "beadswim/scene/swimmer_parameters.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace beadswim {
namespace {

constexpr std::size_t max_notes = 4;  // lines that fit on a figure

/// Returns "4" for equal numbers, "4, 5, 4" otherwise.
std::string values(const std::vector<double>& numbers) {
  std::vector<std::string> texts;
  for (const double number : numbers) texts.push_back(fmt::format("{:.4g}", number));
  if (std::ranges::count(texts, texts.front()) == static_cast<long>(texts.size())) return texts.front();
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string direction(DrivingFrame frame) {
  switch (frame) {
    case DrivingFrame::lab:
      return "along x";
    case DrivingFrame::initial_axis:
      return "along the initial axis";
    case DrivingFrame::body:
      return "along the arms";
  }
  return "";
}

}  // namespace

std::string body_parameters(const SwimmerType& type) {
  const auto& [one, two, three] = type.beads;
  const auto& [first, second] = type.springs;
  std::string text = fmt::format(
      "λ = {}, bead density {}, l = {}, k = {}", values({one.radius, two.radius, three.radius}),
      values({one.density, two.density, three.density}), values({first.rest_length, second.rest_length}),
      values({first.stiffness, second.stiffness}));
  if (first.damping != 0 || second.damping != 0)
    text += fmt::format(", c = {}", values({first.damping, second.damping}));
  return text + fmt::format(", KA = {:.4g}", type.angular_stiffness);
}

std::string driving_parameters(const Driving& driving) {
  const auto& [a, b] = driving.amplitude;
  std::string text = a == b ? fmt::format("A = B = {:.4g}", a) : fmt::format("A = {:.4g}, B = {:.4g}", a, b);
  text += fmt::format(", α = {:.4g} rad, T = {:.6g}", driving.phase, driving.period);
  if (driving.phase_offset != 0) text += fmt::format(", φ = {:.4g} rad", driving.phase_offset);
  return text + ", " + direction(driving.frame);
}

std::vector<std::string> type_notes(const Layout& layout) {
  std::vector<std::string> notes;
  for (const auto& [name, type] : layout.types) {
    if (notes.size() == max_notes) return notes;
    const auto overridden = [&name = name](const Swimmer& s) { return s.type == name && s.driving; };
    const auto own = std::ranges::count_if(layout.swimmers, overridden);
    notes.push_back((layout.types.size() == 1 ? "" : name + ": ") + body_parameters(type) + "; " +
                    driving_parameters(type.driving));
    if (own > 0) notes.back() += fmt::format(" ({} driven otherwise)", own);
  }
  return notes;
}

}  // namespace beadswim
