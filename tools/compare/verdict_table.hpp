#pragma once

#include <string>

#include "beadswim/documents/verdict_document.hpp"

namespace beadswim {

/// Formats a comparison as a table with the columns quantity, run, reference, method, error and verdict. The
/// last line of the table states the verdict over all runs. If it is long, it has the rows that decide and
/// those of the three methods with the smallest errors, of the eight runs and swimmers with the largest
/// deciding errors; with `shows_all` it has all rows.
std::string verdict_table(const VerdictDocument& document, bool shows_all);

/// Formats the verdict on one run of a stream as one line: study, verdict, errors of the deciding rows.
std::string verdict_line(const VerdictDocument& document);

}  // namespace beadswim
