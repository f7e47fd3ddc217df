#include "beadswim/compare/errors_by_setting.hpp"

#include <algorithm>
#include <cmath>

#include "beadswim/compare/comparison.hpp"
#include "beadswim/core/median.hpp"

namespace beadswim {
namespace {

/// Sums over the swimmers of a run, for one component of a quantity (an arm, for arm amplitudes).
struct SquareSums {
  double change = 0, reference = 0;

  double ratio() const { return change == 0 ? 0 : std::sqrt(change / reference); }
};

/// Returns for each quantity the error of each of its components.
std::map<ResultQuantity, std::vector<double>> errors_of(const CostedRun& run,
                                                        std::span<const Results> reference) {
  std::map<ResultQuantity, std::vector<SquareSums>> sums;
  for (std::size_t s = 0; s < run.swimmers.size(); ++s) {
    for (const auto& [quantity, correct] : reference[reference.size() == 1 ? 0 : s]) {
      const auto found = run.swimmers[s].find(quantity);
      if (found == run.swimmers[s].end()) continue;
      std::vector<SquareSums>& own = sums[quantity];
      const std::vector<double>&values = found->second.numbers, &others = correct.numbers;
      own.resize(std::max(own.size(), others.size()));
      for (std::size_t i = 0; i < others.size(); ++i) {
        own[i].change += std::pow(values[i] - others[i], 2);
        own[i].reference += std::pow(others[i], 2);
      }
    }
  }
  std::map<ResultQuantity, std::vector<double>> errors;
  for (const auto& [quantity, components] : sums)
    for (const SquareSums& component : components) errors[quantity].push_back(component.ratio());
  return errors;
}

/// Evaluates the errors of `runs`, which have the same setting and the same resolution.
ErrorsAtResolution errors_of(const std::vector<const CostedRun*>& runs, std::span<const Results> reference) {
  std::vector<double> costs;
  std::map<ResultQuantity, std::vector<double>> errors;
  for (const CostedRun* run : runs) {
    costs.push_back(run->cost);
    for (const auto& [quantity, values] : errors_of(*run, reference))
      errors[quantity].insert(errors[quantity].end(), values.begin(), values.end());
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
                                               std::span<const Results> reference) {
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
