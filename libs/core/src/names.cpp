#include "beadswim/core/names.hpp"

#include <fmt/core.h>

#include <cctype>

#include "beadswim/core/joined.hpp"

namespace beadswim {
namespace {

enum class Part { whole, any };

bool is_same(unsigned char a, unsigned char b) {
  return std::tolower(a) == std::tolower(b);
}

/// Returns the optimal string alignment distance (restricted Damerau-Levenshtein) between `a` and the
/// complete `b` (Part::whole), or the smallest distance between `a` and any part of `b` (Part::any).
std::size_t edit_distance(const std::string& a, const std::string& b, Part part) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = part == Part::whole ? j : 0;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitution = d[i - 1][j - 1] + (is_same(a[i - 1], b[j - 1]) ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, substitution});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  const std::vector<std::size_t>& last = d[a.size()];
  return part == Part::whole ? last.back() : *std::min_element(last.begin(), last.end());
}

/// Returns true if `name` may be a misspelling of `candidate`. If n is the number of letters of `name`, one
/// of these conditions suffices:
///   - the edit distance is less than n, and at most max(2, n/3), or at most 1 if n < 4
///   - n >= 3, and the edit distance to a part of the candidate is at most n/4
bool is_near(const std::string& name, const std::string& candidate) {
  // Longer names occur only in damaged documents. The evaluation of their edit distances would take long.
  constexpr std::size_t max_length = 100;
  if (name.size() > max_length) return false;
  const std::size_t distance = edit_distance(name, candidate, Part::whole);
  const std::size_t max_distance = name.size() < 4 ? 1 : std::max<std::size_t>(2, name.size() / 3);
  if (distance < name.size() && distance <= max_distance) return true;
  return name.size() >= 3 && edit_distance(name, candidate, Part::any) <= name.size() / 4;
}

}  // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates) {
  std::string nearest;
  std::size_t min_distance = 0;
  for (const std::string& candidate : candidates) {
    if (!is_near(name, candidate)) continue;
    const std::size_t distance = edit_distance(name, candidate, Part::whole);
    if (!nearest.empty() && distance >= min_distance) continue;
    nearest = candidate;
    min_distance = distance;
  }
  return nearest;
}

std::string format_suggestion(const std::string& name, const std::vector<std::string>& candidates) {
  const std::string nearest = nearest_name(name, candidates);
  return nearest.empty() ? std::string(".") : fmt::format("; did you mean \"{}\"?", nearest);
}

std::string format_unknown_name(const std::string& name, const std::vector<std::string>& allowed) {
  return fmt::format("unknown value \"{}\"{} Valid values: {}", name, format_suggestion(name, allowed),
                     joined(allowed, ", "));
}

}  // namespace beadswim
