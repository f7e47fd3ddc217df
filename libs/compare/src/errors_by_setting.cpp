#include "beadswim/compare/errors_by_setting.hpp"

#include <algorithm>

#include "beadswim/compare/comparison.hpp"
#include "beadswim/core/median.hpp"

namespace beadswim {
namespace {

/// Evaluates the errors of `runs`, which have the same setting and the same resolution.
ErrorsAtResolution errors_of(const std::vector<const CostedRun*>& runs,
                             std::span<const ComparedValues> reference) {
  std::vector<double> costs;
  std::map<ComparedQuantity, std::vector<double>> errors;
  for (const CostedRun* run : runs) {
    costs.push_back(run->cost);
    for (std::size_t s = 0; s < run->swimmers.size(); ++s) {
      for (const auto& [quantity, values] : reference[reference.size() == 1 ? 0 : s]) {
        for (std::size_t i = 0; i < values.size(); ++i)
          errors[quantity].push_back(relative_error(run->swimmers[s].at(quantity)[i], values[i]));
      }
    }
  }
  ErrorsAtResolution result{.resolution = runs.front()->resolution,
                            .source = runs.front()->source,
                            .cost = median(costs),
                            .errors = {}};
  for (const auto& [quantity, values] : errors) result.errors[quantity] = root_mean_square(values);
  return result;
}

}  // namespace

std::vector<ErrorsOfSetting> errors_by_setting(std::span<const CostedRun> runs,
                                               std::span<const ComparedValues> reference) {
  std::vector<std::pair<std::string, std::map<double, std::vector<const CostedRun*>>>> groups;
  for (const CostedRun& run : runs) {
    auto group = std::ranges::find(groups, run.setting, [](const auto& each) { return each.first; });
    if (group == groups.end()) group = groups.insert(groups.end(), {run.setting, {}});
    group->second[run.resolution].push_back(&run);
  }
  std::vector<ErrorsOfSetting> all;
  for (const auto& [setting, by_resolution] : groups) {
    all.push_back({setting, {}});
    for (const auto& [resolution, group] : by_resolution)
      all.back().resolutions.push_back(errors_of(group, reference));
  }
  return all;
}

}  // namespace beadswim
