#pragma once

#include <optional>
#include <string>
#include <vector>

namespace beadswim {

/// The command line of beadswim-theory.
struct TheoryRequest {
  std::string layout_path = "-";
  std::vector<std::string> methods{"all"};
  std::optional<int> swimmer;              ///< id; nullopt: all swimmers must have the same parameters
  std::optional<std::string> stroke_path;  ///< run record that contains the stroke
  double tolerance = 0.05;  ///< relative error of second-order methods above which a warning is printed
  bool json_lines = false;  ///< true: reads one layout per line and writes one document per line
};

}  // namespace beadswim
