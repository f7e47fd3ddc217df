#include "swimming_files.hpp"

#include <fmt/core.h>

#include <sstream>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

bool is_blank(const std::string& line) {
  return line.find_first_not_of(" \t\r") == std::string::npos;
}

SwimmingDocument swimming_in(const std::string& text, const std::string& source) {
  const Json json = parse_json(text, source);
  const bool says = json.is_object() && json.contains("schema") && json["schema"].is_string();
  const std::string schema = says ? json["schema"].get<std::string>() : "";
  if (schema.starts_with("beadswim/run/")) return run_record_from_json(json, source);
  if (schema.starts_with("beadswim/prediction/")) return predictions_from_json(json, source);
  throw InputError(source, fmt::format("{}; a run record (\"schema\": \"beadswim/run/1\") or a prediction "
                                       "(\"beadswim/prediction/1\") is needed here",
                                       says ? "is \"" + schema + "\"" : "does not say what it is"));
}

/// Several lines, the first of which is a document by itself.
bool holds_json_lines(const std::string& text) {
  std::istringstream lines(text);
  std::string first, next;
  while (std::getline(lines, first) && is_blank(first)) {
  }
  while (std::getline(lines, next) && is_blank(next)) {
  }
  return !is_blank(next) && Json::accept(first);
}

std::vector<SourceDocument> documents_by_line(const std::string& text, const std::string& file) {
  std::vector<SourceDocument> documents;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::string source = fmt::format("{} line {}", file, ++number);
    if (!is_blank(line)) documents.push_back({source, swimming_in(line, source)});
  }
  return documents;
}

}  // namespace

std::vector<SourceDocument> read_swimming_file(const std::string& path) {
  if (path.ends_with(".h5md")) return {{path, read_run(path)}};  // which says what to give instead
  const std::string source = source_name(path);
  const std::string text = read_text(path);
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw InputError(source, "is empty; a run record or a prediction is needed here");
  }
  if (holds_json_lines(text)) return documents_by_line(text, source);
  return {{source, swimming_in(text, source)}};
}

}  // namespace beadswim
