#pragma once

#include <optional>
#include <string>

#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/theory/stroke.hpp"

namespace beadswim {

/// A stroke and the unit system that its amplitudes are in.
struct MeasuredStroke {
  std::string source;  ///< the file, for messages
  Units units;
  Stroke stroke;
};

/// The stroke of a run's last cycle: of the swimmer of that id, or of the run's first one.
/// Throws InputError if there is no such swimmer or it has not finished a cycle.
MeasuredStroke read_measured_stroke(const std::string& path, std::optional<int> swimmer);

}  // namespace beadswim
