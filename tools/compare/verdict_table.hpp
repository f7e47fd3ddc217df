#pragma once

#include <string>

#include "beadswim/documents/verdict_document.hpp"

namespace beadswim {

/// Formats a comparison as a table with the columns quantity, run, reference, method, error and verdict. The
/// last line of the table states the verdict over all runs.
std::string verdict_table(const VerdictDocument& document);

}  // namespace beadswim
