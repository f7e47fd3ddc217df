#include "comparison_stream.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/failure_document.hpp"
#include "beadswim/documents/trajectory_file.hpp"

namespace beadswim {
namespace {

/// Returns the study of a document; null if it belongs to none.
Json study_in(const Json& document) {
  return document.is_object() ? document.value("study", Json()) : Json();
}

/// Throws InputError if the document is a failure.
void require_result(const Json& document, const std::string& source) {
  if (is_failure(document))
    throw InputError(fmt::format("{} is a failure: {}", source, document.value("reason", "")));
}

}  // namespace

ComparisonFiles::File ComparisonFiles::open(const std::string& path) {
  if (is_trajectory(path)) return {.path = path, .stream = std::nullopt};
  File file{.path = path, .stream = DocumentStream({path})};
  file.is_single = file.stream->is_single();
  return file;
}

ComparisonFiles::ComparisonFiles(const ComparisonRequest& request) {
  if (request.files.size() < 2) {
    throw InputError("RUN... REFERENCE",
                     "{} is given; name at least one run record, and after the run records the reference for "
                     "the comparison",
                     request.files.empty() ? "no file" : "one file");
  }
  std::vector<std::string> all = request.files;
  all.insert(all.end(), request.further_references.begin(), request.further_references.end());
  require_one_standard_input(all);
  for (std::size_t i = 0; i + 1 < request.files.size(); ++i) runs_.push_back(open(request.files[i]));
  references_.push_back(open(request.files.back()));
  for (const std::string& path : request.further_references) references_.push_back(open(path));
}

bool ComparisonFiles::is_stream() const {
  const auto is_several = [](const File& file) { return !file.is_single; };
  return std::ranges::any_of(runs_, is_several) || std::ranges::any_of(references_, is_several);
}

const SwimmingDocument& ComparisonFiles::only_document(File& file) {
  if (file.only) return *file.only;
  if (!file.stream) return file.only.emplace(run_of_trajectory(file.path));
  const StreamMember member = *file.stream->next();
  return file.only.emplace(swimming_from_json(parse_json(member.text, member.source), member.source));
}

ComparisonInputs ComparisonFiles::all() {
  ComparisonInputs inputs;
  for (File& file : runs_) {
    const std::string source = source_name(file.path);
    const auto member = file.stream ? file.stream->next() : std::nullopt;
    inputs.runs.push_back({source, member ? run_from_json(parse_json(member->text, source), source)
                                          : run_of_trajectory(file.path)});
  }
  for (File& file : references_) inputs.references.push_back({source_name(file.path), only_document(file)});
  return inputs;
}

StoredStream ComparisonFiles::runs() {
  StoredStream runs;
  for (File& file : runs_) {
    if (!file.stream) {
      run_of_trajectory(file.path);
      runs.add({.text = {}, .source = file.path});
    }
    while (const auto member = file.stream ? file.stream->next() : std::nullopt) {
      const Json json = parse_json(member->text, member->source);
      if (!is_failure(json)) run_record_from_json(json, member->source);
      runs.add(*member);
    }
  }
  for (File& file : references_) {
    if (file.is_single) only_document(file);
    while (const auto member = file.is_single ? std::nullopt : file.stream->next()) {
      const Json json = parse_json(member->text, member->source);
      if (!is_failure(json)) swimming_from_json(json, member->source);
    }
    if (!file.is_single) file.stream->rewind();
  }
  return runs;
}

/// Returns the document of the file with this study. Throws InputError if there is none. The search goes on
/// from the place of the last one, so that files with the same order are read once.
SourceDocument ComparisonFiles::reference_for(File& file, const Json& study) {
  if (file.is_single) return {source_name(file.path), only_document(file)};
  for (int pass = 0; pass < 2; ++pass) {
    while (const auto member = file.stream->next()) {
      const Json json = parse_json(member->text, member->source);
      if (study_in(json) != study) continue;
      require_result(json, member->source);
      return {member->source, swimming_from_json(json, member->source)};
    }
    file.stream->rewind();
  }
  throw InputError(fmt::format("{} has no document {}", source_name(file.path),
                               study.is_null() ? "without a study" : "of the study " + study.dump()));
}

ComparisonInputs ComparisonFiles::inputs_of(const StreamMember& run) {
  ComparisonInputs inputs;
  Json study;
  if (run.text.empty()) {
    inputs.runs.push_back({run.source, run_of_trajectory(run.source)});
  } else {
    const Json json = parse_json(run.text, run.source);
    require_result(json, run.source);
    study = study_in(json);
    inputs.runs.push_back({run.source, run_from_json(json, run.source)});
  }
  for (File& reference : references_) inputs.references.push_back(reference_for(reference, study));
  return inputs;
}

}  // namespace beadswim
