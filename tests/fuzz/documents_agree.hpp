#pragma once

#include <optional>
#include <vector>

#include "accepted.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {

/// Requires that `written`, a document that was read and written again, agrees with `given`: the same members
/// with the same values, to the last bit. Members that are null or empty may be omitted. Members with the
/// names in the list, at any depth, are not compared, because the reader may write them in another form.
void require_agreement(const Json& given, const Json& written,
                       const std::vector<std::string>& in_other_words);

/// Reads a document and writes it again with `rewrite`. If the document is accepted, requires that the
/// written document contains only finite numbers and does not change when it is read and written once more.
template <class Rewrite>
std::optional<Json> written_again(const Json& given, const Rewrite& rewrite) {
  Json written, again;
  if (!accepts([&] { written = rewrite(given); })) return std::nullopt;
  const std::string text = dump_json(written);  // throws if a number is not finite
  require(accepts([&] { again = rewrite(parse_json(text, "written")); }), "what is written can be read");
  require(again == written, "a document read and written twice stays the same");
  return written;
}

/// Does the same for a text, which may be invalid JSON.
template <class Rewrite>
void require_rewritten_alike(const std::string& text, const std::vector<std::string>& in_other_words,
                             const Rewrite& rewrite) {
  Json given;
  if (!accepts([&] { given = parse_json(text, "given"); })) return;
  if (const auto written = written_again(given, rewrite)) require_agreement(given, *written, in_other_words);
}

}  // namespace beadswim
