#include "swimming_files.hpp"

#include <fmt/core.h>

#include <sstream>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

bool is_blank(const std::string& line) {
  return line.find_first_not_of(" \t\r") == std::string::npos;
}

SwimmingDocument swimming_in(const Json& json, const std::string& source) {
  const std::string schema = schema_of(json);
  if (schema.starts_with("beadswim/run/")) return run_record_from_json(json, source);
  if (schema.starts_with("beadswim/prediction/")) return predictions_from_json(json, source);
  if (schema.starts_with("beadswim/verdict/"))
    throw InputError(source, "is a verdict, which speed-against-error alone draws, and without --reference");
  throw InputError(source, fmt::format("{}; a run record (\"schema\": \"beadswim/run/1\") or a prediction "
                                       "(\"beadswim/prediction/1\") is needed here",
                                       schema.empty() ? "does not say what it is" : "is \"" + schema + "\""));
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

std::vector<SourceJson> documents_by_line(const std::string& text, const std::string& file) {
  std::vector<SourceJson> documents;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::string source = fmt::format("{} line {}", file, ++number);
    if (!is_blank(line)) documents.push_back({source, parse_json(line, source)});
  }
  return documents;
}

}  // namespace

std::string schema_of(const Json& document) {
  const bool says = document.is_object() && document.contains("schema") && document["schema"].is_string();
  return says ? document["schema"].get<std::string>() : "";
}

std::vector<SourceJson> read_json_documents(const std::string& path, const std::string& wanted) {
  const std::string source = source_name(path);
  const std::string text = read_text(path);
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    throw InputError(source, fmt::format("is empty; {} is needed here", wanted));
  if (holds_json_lines(text)) return documents_by_line(text, source);
  return {{source, parse_json(text, source)}};
}

std::vector<SourceDocument> read_swimming_file(const std::string& path) {
  if (path.ends_with(".h5md")) return {{path, read_run(path)}};  // which says what to give instead
  std::vector<SourceDocument> documents;
  for (const SourceJson& each : read_json_documents(path, "a run record or a prediction"))
    documents.push_back({each.source, swimming_in(each.json, each.source)});
  return documents;
}

}  // namespace beadswim
