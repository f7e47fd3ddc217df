#include "beadswim/scene/swimmer_parameters.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <functional>

#include "beadswim/core/joined.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"

namespace beadswim {
namespace {

constexpr std::size_t max_notes = 4;  // lines that fit on a figure

/// Returns one number of each part as text: "4" for equal numbers, "4, 5, 4" otherwise, or "4 to 6" for more
/// than three.
std::string values(const auto& parts, auto number) {
  std::vector<double> numbers;
  std::vector<std::string> texts;
  for (const auto& part : parts) {
    numbers.push_back(std::invoke(number, part));
    texts.push_back(fmt::format("{:.4g}", numbers.back()));
  }
  if (std::ranges::count(texts, texts.front()) == std::ssize(texts)) return texts.front();
  if (texts.size() <= 3) return joined(texts, ", ");
  const auto [least, most] = std::ranges::minmax(numbers);
  return fmt::format("{:.4g} to {:.4g}", least, most);
}

/// Directions of the driving forces, in the order of DrivingFrame.
constexpr std::array directions{"along x", "along the initial axis", "along the arms"};

/// Returns the parameters of beads and springs: "λ = 6, bead density 1, l = 32, k = 0.2, KA = 2048". Non-zero
/// damping is included. Values that differ between beads or arms are separated by commas.
std::string body_parameters(const SwimmerType& type) {
  std::string text = fmt::format("λ = {}, bead density {}", values(type.beads, &Bead::radius),
                                 values(type.beads, &Bead::density));
  if (!type.bonds.empty()) {
    text += fmt::format(", l = {}, k = {}", values(type.bonds, &Spring::rest_length),
                        values(type.bonds, &Spring::stiffness));
    if (std::ranges::any_of(type.bonds, [](const Bond& bond) { return bond.damping != 0; }))
      text += fmt::format(", c = {}", values(type.bonds, &Spring::damping));
  }
  if (!type.angles.empty()) text += fmt::format(", KA = {}", values(type.angles, &Angle::stiffness));
  return text;
}

}  // namespace

std::string driving_parameters(const Driving& driving) {
  std::string text;
  const auto three = three_bead_form(driving);
  if (three) {
    const auto& [a, b] = three->amplitude;
    text = a == b ? fmt::format("A = B = {:.4g}", a) : fmt::format("A = {:.4g}, B = {:.4g}", a, b);
    text += fmt::format(", α = {:.4g} rad", three->phase);
  } else {
    const std::size_t drives = driving.forces.size() + driving.bonds.size() + driving.angles.size();
    text = fmt::format("{} drive{}", drives, drives == 1 ? "" : "s");
  }
  text += fmt::format(", T = {:.6g}", driving.period);
  if (driving.phase_offset != 0) text += fmt::format(", φ = {:.4g} rad", driving.phase_offset);
  return three ? text + ", " + directions[static_cast<int>(driving.frame)] : text;
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
