#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "beadswim/compare/comparison.hpp"
#include "beadswim/compare/cycle_choice.hpp"
#include "beadswim/documents/prediction_document.hpp"
#include "beadswim/documents/run_record_document.hpp"

// Documents with velocity and stroke of swimmers: run records and predictions.

namespace beadswim {

/// A run record or a prediction document.
using SwimmingDocument = std::variant<RunRecord, PredictionDocument>;

/// Returns the name of `path` in messages: the path, or "standard input" for "-".
std::string source_name(const std::string& path);

/// Reads a run record that contains statistics of single swimmers. Throws InputError as read_run_record()
/// does, and with a remedy for a trajectory (.h5md) or a record without swimmers.
RunRecord read_run(const std::string& path);

/// A JSON document and its name in messages: "FILE", or "FILE line N" if the file contains several documents.
struct SourceJson {
  std::string source;
  Json json;
};

/// Returns the schema of a document, such as "beadswim/run/1"; empty if the document does not state it.
std::string schema_of(const Json& document);

/// Reads the documents of a file, or of stdin for "-": one document, or JSON lines with one document per
/// line. Throws InputError if there is no document or one is invalid. `wanted`: expected documents, for the
/// message.
std::vector<SourceJson> read_json_documents(const std::string& path, const std::string& wanted);

/// Converts a run record or a prediction document, depending on its schema. Otherwise throws InputError.
SwimmingDocument swimming_from_json(const Json& document, const std::string& source);

/// Reads one such document from a file, or from stdin for "-". Throws InputError.
SwimmingDocument read_swimming(const std::string& path);

/// Returns the mean velocity and stroke of a swimmer in the chosen cycles. Throws InputError if any is
/// missing.
ComparedValues swimming_of(const RunRecord& run, const SwimmerRecord& swimmer, const CycleChoice& choice,
                           const std::string& source);

/// Returns velocity and stroke of a prediction.
ComparedValues swimming_of(const Prediction& prediction);

/// Returns the swimmer with that id. Throws InputError, which lists the ids of the run, if there is none.
const SwimmerRecord& find_swimmer(const RunRecord& run, int id, const std::string& source);

/// Returns the period of the driving from the settings of the predictions [time]; nullopt if no setting
/// states it.
std::optional<double> driving_period(const PredictionDocument& document);

}  // namespace beadswim
