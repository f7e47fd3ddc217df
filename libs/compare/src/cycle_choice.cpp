#include "beadswim/compare/cycle_choice.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"

namespace beadswim {
namespace {

/// Returns true if no cycle is missing between the first and the last.
bool are_all(std::span<const CycleStatistics> cycles) {
  return cycles.back().index - cycles.front().index + 1 == std::ssize(cycles);
}

}  // namespace

CycleChoice parse_cycle_choice(const std::string& text) {
  if (text == "last") return {};
  constexpr std::string_view mean_prefix = "mean:";
  const bool mean = text.starts_with(mean_prefix);
  const std::string_view digits = std::string_view(text).substr(mean ? mean_prefix.size() : 0);
  int number = 0;
  const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (fault != std::errc{} || end != digits.data() + digits.size() || number < 1) {
    throw InputError(Setting::cycle,
                     "\"{}\" must be \"last\", the number of a cycle (1 or more), or \"mean:N\" for the mean "
                     "of the last N cycles (N is 1 or more)",
                     text);
  }
  return {mean ? CycleChoice::Kind::last : CycleChoice::Kind::index, number};
}

std::span<const CycleStatistics> find_cycles(std::span<const CycleStatistics> cycles,
                                             const CycleChoice& choice) {
  const auto number = static_cast<std::size_t>(choice.number);
  if (choice.kind == CycleChoice::Kind::last)
    return number <= cycles.size() && are_all(cycles.last(number)) ? cycles.last(number) : cycles.first(0);
  const auto found = std::ranges::find(cycles, choice.number, &CycleStatistics::index);
  return cycles.subspan(found - cycles.begin(), found == cycles.end() ? 0 : 1);
}

std::span<const CycleStatistics> select_cycles(std::span<const CycleStatistics> cycles,
                                               const CycleChoice& choice, const std::string& source) {
  if (cycles.empty()) {
    throw InputError(source, "the run record contains no complete cycle; run for one cycle or more");
  }
  if (const auto found = find_cycles(cycles, choice); !found.empty()) return found;
  const std::string wanted = choice.kind == CycleChoice::Kind::index
                                 ? fmt::format("cycle {}", choice.number)
                                 : fmt::format("the last {} cycles", choice.number);
  throw InputError(source, "the run does not contain {}, only {}cycles {} to {}; give {} another value",
                   wanted, are_all(cycles) ? "" : "some of the ", cycles.front().index, cycles.back().index,
                   Setting::cycle);
}

}  // namespace beadswim
