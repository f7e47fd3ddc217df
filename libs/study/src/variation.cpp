#include "beadswim/study/variation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "beadswim/core/error.hpp"

namespace beadswim {

std::vector<StudyPoint> study_points(const std::vector<Variation>& variations, bool together,
                                     const std::string& flag) {
  std::set<std::string> names;
  for (const Variation& variation : variations)
    if (!names.insert(variation.name).second)
      throw InputError(flag,
                       fmt::format("\"{}\" is named twice; give all its values at once", variation.name));
  std::size_t count = together ? variations.front().values.size() : 1;
  for (const Variation& variation : variations) {
    if (!together) count *= variation.values.size();
    if (count > max_study_points)
      throw InputError(flag,
                       fmt::format("the grid has more than {} layouts; give fewer values", max_study_points));
  }
  std::vector<StudyPoint> points(count);
  for (std::size_t p = 0; p < count; ++p) {
    std::size_t rest = p;
    for (auto variation = variations.rbegin(); variation != variations.rend(); ++variation) {
      const std::size_t values = variation->values.size();
      points[p].emplace_back(variation->name, variation->values[together ? p : rest % values]);
      rest /= values;
    }
    std::ranges::reverse(points[p]);
  }
  return points;
}

}  // namespace beadswim
