#pragma once

#include <optional>
#include <string>

#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/theory/stroke.hpp"

namespace beadswim {

/// Stroke of a swimmer that a run measured, with units and driving period of the run.
struct MeasuredStroke {
  std::string source;  ///< path of the run record, for messages
  Units units;
  double period = 0;  ///< period of the driving [time]
  Stroke stroke;
};

/// Reads the stroke in the last cycle of a run from its record. `swimmer`: id of the swimmer; nullopt: the
/// first swimmer of the record. Throws InputError if the record has no such swimmer, or if the swimmer has
/// not completed a cycle.
MeasuredStroke read_measured_stroke(const std::string& path, std::optional<int> swimmer);

}  // namespace beadswim
