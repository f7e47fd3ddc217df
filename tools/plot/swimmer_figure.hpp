#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/figure/swimmer_sketch.hpp"

namespace beadswim {

/// The swimmer of that id, none: the first, of the one layout ("-" for standard input) that the files are.
/// Throws InputError.
SwimmerSketch swimmer_figure(const std::vector<std::string>& files, std::optional<int> id);

}  // namespace beadswim
