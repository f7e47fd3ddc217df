#pragma once

#include <string>

#include "beadswim/documents/verdict_document.hpp"

namespace beadswim {

/// The rows for people: quantity, run, reference, method, error, verdict; the final line is the verdict.
std::string verdict_table(const VerdictDocument& document);

}  // namespace beadswim
