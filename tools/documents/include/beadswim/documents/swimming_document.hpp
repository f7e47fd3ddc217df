#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "beadswim/compare/comparison.hpp"
#include "beadswim/compare/cycle_choice.hpp"
#include "beadswim/documents/prediction_document.hpp"
#include "beadswim/documents/run_record_document.hpp"

// Run records and predictions, seen alike: documents that say how swimmers swim.

namespace beadswim {

using SwimmingDocument = std::variant<RunRecord, PredictionDocument>;

/// How messages call what was read from `path`.
std::string source_name(const std::string& path);

/// Reads a run record for its cycles' statistics. As read_run_record, and says of a trajectory (.h5md) what
/// to give instead.
RunRecord read_run(const std::string& path);

/// A document and what messages call it: "FILE", or "FILE line N" of a file of several.
struct SourceJson {
  std::string source;
  Json json;
};

/// "beadswim/run/1"; empty if the document does not say what it is.
std::string schema_of(const Json& document);

/// The documents of a file, or of stdin for "-": one, or JSON lines, one a line. Throws InputError naming the
/// source, also if there is none; `wanted` says what should be there.
std::vector<SourceJson> read_json_documents(const std::string& path, const std::string& wanted);

/// A run record or a prediction, whichever the document says it is. Throws InputError naming the source.
SwimmingDocument swimming_from_json(const Json& document, const std::string& source);

/// Reads a file of one such document, or stdin for "-". Throws InputError.
SwimmingDocument read_swimming(const std::string& path);

/// How a swimmer of the run swam in the chosen cycles, on average. Throws InputError naming `source`.
Swimming swimming_of(const RunRecord& run, const SwimmerRecord& swimmer, const CycleChoice& choice,
                     const std::string& source);

Swimming swimming_of(const Prediction& prediction);

/// The run's swimmer of that id. Throws InputError naming `source` and the ids there are.
const SwimmerRecord& find_swimmer(const RunRecord& run, int id, const std::string& source);

/// Period of the driving, if the predictions' settings say it.
std::optional<double> driving_period(const PredictionDocument& document);

}  // namespace beadswim
