#include "beadswim/documents/study_text.hpp"

#include <fmt/core.h>

namespace beadswim {

std::string study_value_text(const Json& value, int digits) {
  return value.is_string() ? value.get<std::string>() : fmt::format("{:.{}g}", value.get<double>(), digits);
}

std::string study_text(const Json& study, int digits) {
  std::string text;
  for (const auto& [name, value] : study.items())
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name, study_value_text(value, digits));
  return text;
}

}  // namespace beadswim
