#include <fmt/core.h>

#include <cmath>

#include "beadswim/core/error.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {
namespace {

constexpr std::size_t line_width = 110;
constexpr std::size_t indent_width = 2;

/// Throws SolverError if the document contains a non-finite number, which JSON cannot represent.
void require_finite(const Json& value, const std::string& pointer) {
  if (value.is_number_float() && !std::isfinite(value.get<double>())) {
    throw SolverError(
        fmt::format("the result at {} is {}, not a finite number, which JSON cannot contain; check the input "
                    "for extreme values",
                    pointer, value.get<double>()));
  }
  if (value.is_object()) {
    for (const auto& [key, member] : value.items()) require_finite(member, pointer + pointer_step(key));
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) require_finite(value[i], fmt::format("{}/{}", pointer, i));
  }
}

std::string quoted(const std::string& key) {
  return Json(key).dump();
}

/// Appends the value on the current line. Returns false as soon as the line is longer than line_width. The
/// text may then end with an incomplete value.
bool append_on_one_line(const Json& value, std::size_t line_start, std::string& text) {
  if (!value.is_structured()) {
    text += value.dump();
  } else if (value.empty()) {
    text += value.is_object() ? "{}" : "[]";
  } else {
    text += value.is_object() ? "{ " : "[";
    bool first = true;
    for (const auto& [key, member] : value.items()) {
      if (!first) text += ", ";
      first = false;
      if (value.is_object()) text += quoted(key) + ": ";
      if (!append_on_one_line(member, line_start, text)) return false;
    }
    text += value.is_object() ? " }" : "]";
  }
  return text.size() - line_start <= line_width;
}

/// Appends the value, on several lines if it does not fit on one line.
void append(const Json& value, std::size_t depth, std::size_t line_start, std::string& text) {
  const std::size_t before = text.size();
  if (append_on_one_line(value, line_start, text) || !value.is_structured()) return;
  text.resize(before);
  text += value.is_object() ? "{" : "[";
  bool first = true;
  for (const auto& [key, member] : value.items()) {
    text += first ? "\n" : ",\n";
    first = false;
    const std::size_t start = text.size();
    text.append((depth + 1) * indent_width, ' ');
    if (value.is_object()) text += quoted(key) + ": ";
    append(member, depth + 1, start, text);
  }
  text += '\n';
  text.append(depth * indent_width, ' ');
  text += value.is_object() ? "}" : "]";
}

}  // namespace

std::string dump_json(const Json& document) {
  require_finite(document, "");
  std::string text;
  append(document, 0, 0, text);
  return text + "\n";
}

std::string dump_json_line(const Json& document) {
  require_finite(document, "");
  return document.dump() + "\n";
}

}  // namespace beadswim
