#include "beadswim/compare/cycle_choice.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"

namespace beadswim {

CycleChoice parse_cycle_choice(const std::string& text) {
  if (text == "last") return {};
  constexpr std::string_view mean_prefix = "mean:";
  const bool mean = text.starts_with(mean_prefix);
  const std::string_view digits = std::string_view(text).substr(mean ? mean_prefix.size() : 0);
  int number = 0;
  const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (fault != std::errc{} || end != digits.data() + digits.size() || number < 1) {
    throw InputError(Setting::cycle,
                     fmt::format("\"{}\" must be \"last\", the number of a cycle (1 or more), or \"mean:N\" "
                                 "for the mean of the last N cycles (N is 1 or more)",
                                 text));
  }
  return {mean ? CycleChoice::Kind::last : CycleChoice::Kind::index, number};
}

std::span<const CycleStatistics> select_cycles(std::span<const CycleStatistics> cycles,
                                               const CycleChoice& choice, const std::string& source) {
  if (cycles.empty()) {
    throw InputError(source, "the run record contains no complete cycle; run for one cycle or more");
  }
  const auto number = static_cast<std::size_t>(choice.number);
  const auto are_all = [](std::span<const CycleStatistics> some) {
    return some.back().index - some.front().index + 1 == std::ssize(some);
  };
  if (choice.kind == CycleChoice::Kind::last && number <= cycles.size() && are_all(cycles.last(number)))
    return cycles.last(number);
  const auto found = std::find_if(cycles.begin(), cycles.end(), [&](const CycleStatistics& cycle) {
    return choice.kind == CycleChoice::Kind::index && cycle.index == choice.number;
  });
  if (found != cycles.end()) return {found, 1};
  const std::string wanted = choice.kind == CycleChoice::Kind::index
                                 ? fmt::format("cycle {}", choice.number)
                                 : fmt::format("the last {} cycles", choice.number);
  throw InputError(source,
                   fmt::format("the run does not contain {}, only {}cycles {} to {}; give {} another value",
                               wanted, are_all(cycles) ? "" : "some of the ", cycles.front().index,
                               cycles.back().index, Setting::cycle));
}

}  // namespace beadswim
