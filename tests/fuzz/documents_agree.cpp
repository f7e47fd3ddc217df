#include "documents_agree.hpp"

#include <algorithm>

namespace beadswim {
namespace {

bool says_nothing(const Json& value) {
  return value.is_null() || (value.is_structured() && value.empty()) || value == "";
}

/// Returns true if both numbers are equal, or if one is the double nearest to the other.
bool same_number(const Json& given, const Json& written) {
  if (given.is_number_float() || written.is_number_float())
    return given.get<double>() == written.get<double>();
  return given == written;
}

bool agree(const Json& given, const Json& written, const std::vector<std::string>& in_other_words);

bool same_members(const Json& given, const Json& written, const std::vector<std::string>& in_other_words) {
  return std::ranges::all_of(given.items(), [&](const auto& member) {
    if (std::ranges::find(in_other_words, member.key()) != in_other_words.end()) return true;
    const auto found = written.find(member.key());
    return found == written.end() ? says_nothing(member.value())
                                  : agree(member.value(), *found, in_other_words);
  });
}

bool agree(const Json& given, const Json& written, const std::vector<std::string>& in_other_words) {
  if (given.is_number() && written.is_number()) return same_number(given, written);
  if (given.is_object() && written.is_object()) return same_members(given, written, in_other_words);
  if (given.is_array() && written.is_array()) {
    const auto agrees = [&](const Json& a, const Json& b) { return agree(a, b, in_other_words); };
    return std::ranges::equal(given, written, agrees);
  }
  return given == written;
}

}  // namespace

void require_agreement(const Json& given, const Json& written,
                       const std::vector<std::string>& in_other_words) {
  require(agree(given, written, in_other_words), "what is written says what was read");
}

}  // namespace beadswim
