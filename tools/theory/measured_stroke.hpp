#pragma once

#include <optional>
#include <string>

#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/theory/stroke.hpp"

namespace beadswim {

/// A stroke, the unit system that it is in, and its period.
struct MeasuredStroke {
  std::string source;  ///< the file, for messages
  Units units;
  double period = 0;  ///< of the driving
  Stroke stroke;
};

/// The stroke of a run's last cycle: of the swimmer of that id, or of the run's first one.
/// Throws InputError if there is no such swimmer or it has not finished a cycle.
MeasuredStroke read_measured_stroke(const std::string& path, std::optional<int> swimmer);

}  // namespace beadswim
