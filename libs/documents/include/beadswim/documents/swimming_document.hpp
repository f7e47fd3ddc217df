#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "beadswim/compare/comparison.hpp"
#include "beadswim/compare/cycle_choice.hpp"
#include "beadswim/documents/prediction_document.hpp"
#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/scene/scene_differences.hpp"

// Documents that contain velocity and stroke of swimmers: run records and predictions.

namespace beadswim {

/// A run record or a prediction document.
using SwimmingDocument = std::variant<RunRecord, PredictionDocument>;

/// A run record or a prediction document, and the name of its file in messages.
struct SourceDocument {
  std::string source;
  SwimmingDocument document;
};

/// A run record, and the name of its file in messages.
struct RunFile {
  std::string source;
  RunRecord record;

  /// Returns the study of the layout; null if the run belongs to none.
  Json study() const { return record.study.value_or(Json()); }
};

/// Returns the name of a file for messages: `path`, or "standard input" if `path` is "-".
std::string source_name(const std::string& path);

/// Converts a JSON document to a run record. The swimmers of a large swarm, which the record does not list,
/// are read from the trajectory beside it (RUN.h5md beside RUN.json). Throws the errors of
/// run_record_from_json() and run_of_trajectory(), and InputError with a remedy if there is no such
/// trajectory.
RunRecord run_from_json(const Json& document, const std::string& source);

/// A JSON document and its name in messages: "FILE", or "FILE line N" if the file contains several documents.
struct SourceJson {
  std::string source;
  Json json;
};

/// Returns the schema name that a document states, such as "beadswim/run/1"; empty if it states none.
std::string schema_of(const Json& document);

/// Reads the JSON documents of a file, or of standard input for "-". The file contains one document, or one
/// document per line (JSON lines). Throws InputError if the file contains no document or an invalid one.
/// `wanted`: name of the expected documents for the error message.
std::vector<SourceJson> read_json_documents(const std::string& path, const std::string& wanted);

/// Converts a JSON document to a run record or a prediction document, as the schema name in the document
/// states. Throws InputError for other schemas.
SwimmingDocument swimming_from_json(const Json& document, const std::string& source);

/// Documents of several files without the failures among them, and the number of these.
struct ReadDocuments {
  std::vector<SourceDocument> documents{};
  int failures = 0;

  int count() const { return static_cast<int>(documents.size()) + failures; }
};

/// Reads the run records of trajectories, and the JSON documents of all other files with `parse`. Throws the
/// errors of read_json_documents(), `parse` and run_of_trajectory(), and InputError if no file is named or
/// several are standard input. `wanted`: name of the expected documents for the error message.
ReadDocuments read_documents(
    const std::vector<std::string>& files, const std::string& wanted,
    const std::function<SwimmingDocument(const Json& document, const std::string& source)>& parse);

/// Returns the units of a document.
const Units& units_of(const SwimmingDocument& document);

/// Returns the ids of the swimmers of which a document contains results.
std::vector<int> swimmers_of(const RunRecord& run);
std::vector<int> swimmers_of(const SwimmingDocument& document);

/// Returns the scales of the motion of a swimmer in the chosen cycles. The speed of beads follows from the
/// Reynolds number, and the numerical error from the tolerance of sums, if the record states them. Throws
/// InputError if the run lacks a chosen cycle.
MotionScale motion_scale_of(const RunRecord& run, const SwimmerRecord& swimmer, const CycleChoice& choice,
                            const std::string& source);

/// Returns the stroke of a swimmer in the last cycle of a run. `swimmer`: its id; nullopt: the first swimmer
/// of the record. `source`: path of the record. Throws InputError if the record has no such swimmer, or if
/// the swimmer has not completed a cycle or has not two arms.
MeasuredStroke measured_stroke(const RunRecord& run, std::optional<int> swimmer, const std::string& source);

/// Returns the record of the swimmer with this id; nullopt: of the first swimmer. Throws InputError if the
/// record has no such swimmer; the message lists the ids of the record.
const SwimmerRecord& find_swimmer(const RunRecord& run, std::optional<int> id, const std::string& source);

/// Returns the differences between the scenes of a run and its reference, which must have the same units. If
/// one of the documents contains no scene, compares the properties that both state: a run record states
/// domain, swimmers and driving, a prediction the driving of its swimmer.
std::vector<SceneDifference> scene_differences(const RunRecord& run, const SwimmingDocument& reference);

/// Returns the difference in words, for example "period 2000 instead of 4800": the value of the reference
/// instead of the value of the run.
std::string in_words(const SceneDifference& difference);

}  // namespace beadswim
