#pragma once

#include <optional>
#include <string>
#include <vector>

namespace beadswim {

/// What the command line asks for.
struct TheoryRequest {
  std::string layout_path = "-";
  std::vector<std::string> methods{"all"};
  std::optional<int> swimmer;              ///< id of the swimmer to predict; none: the swimmers must be alike
  std::optional<std::string> stroke_path;  ///< run record whose stroke is used
  double tolerance = 0.05;  ///< relative error of the velocity at finite amplitude that is not warned of
  bool json_lines = false;  ///< one layout a line in, one document a line out
};

}  // namespace beadswim
