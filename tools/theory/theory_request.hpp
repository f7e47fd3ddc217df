#pragma once

#include <optional>
#include <string>
#include <vector>

namespace beadswim {

/// The command line of beadswim-theory.
struct TheoryRequest {
  std::vector<std::string> layout_paths{"-"};
  std::vector<std::string> methods{"all"};
  std::optional<int> swimmer;              ///< id; nullopt: all swimmers must have the same parameters
  std::optional<std::string> stroke_path;  ///< run record that contains the stroke
  double tolerance = 0.05;  ///< relative error of second-order methods above which a warning is printed
  bool json_lines = false;  ///< true: writes one document per line also for a single layout
  int jobs = 1;             ///< number of processes for a stream
};

}  // namespace beadswim
