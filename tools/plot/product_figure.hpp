#pragma once

#include <string>
#include <vector>

#include "beadswim/figure/figure.hpp"

namespace beadswim {

/// Time of a product of mobility and forces against the number of beads, by surroundings and ranks, of
/// documents that beadswim-bench
/// --beads --json wrote. Throws InputError for documents without products.
Figure product_figure(const std::vector<std::string>& files);

}  // namespace beadswim
