#include "flag_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace beadswim {
namespace {

/// Flags that are not the name of the setting with hyphens.
constexpr auto special_flags = std::to_array<NamedValue<Setting>>({
    {Setting::arm, "--arm"},
    {Setting::checkpoint_every, "--checkpoint-every"},
    {Setting::flow_every, "--flow-every"},
    {Setting::frame, "--frame"},
    {Setting::free_quantity, "--free"},
    {Setting::friction, "--friction"},
    {Setting::limit, "--subject-to"},
    {Setting::lubrication, "--lubrication"},
    {Setting::output, "-o"},
    {Setting::plan, "--plan"},
    {Setting::ranks, "mpirun -n"},
    {Setting::refinement, "--refine"},
    {Setting::repair, "--repair"},
    {Setting::restart, "--restart"},
    {Setting::stroke_record, "--stroke-from"},
    {Setting::sum_tolerance, "--sum-tolerance"},
    {Setting::unbounded, "beadswim-layout swimmer --unbounded"},
    {Setting::verification, "--verify-by"},
});

}  // namespace

std::string flag_of(Setting setting) {
  const auto special = std::ranges::find(special_flags, setting, &NamedValue<Setting>::value);
  if (special != special_flags.end()) return std::string(special->name);
  std::string words = to_text(setting);
  if (words.starts_with("the ")) words.erase(0, 4);
  std::ranges::replace(words, ' ', '-');
  words.front() = static_cast<char>(std::tolower(words.front()));
  return "--" + words;
}

}  // namespace beadswim
