#pragma once

#include <optional>
#include <string>

#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/theory/stroke.hpp"

namespace beadswim {

/// Stroke of a swimmer in a run, with its units and its period.
struct MeasuredStroke {
  std::string source;  ///< path of the run record, for messages
  Units units;
  double period = 0;  ///< period of the driving [time]
  Stroke stroke;
};

/// Reads the stroke of the last cycle from a run record. `swimmer`: id of the swimmer; nullopt: the first
/// swimmer of the record. Throws InputError if there is no such swimmer, or if it has not completed a cycle.
MeasuredStroke read_measured_stroke(const std::string& path, std::optional<int> swimmer);

}  // namespace beadswim
