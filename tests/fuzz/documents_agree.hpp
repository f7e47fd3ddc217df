#pragma once

#include <optional>
#include <vector>

#include "accepted.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {

/// Requires that `written`, a document that was read and written again, says what `given` says: the same
/// members with the same values, to the last bit; a member may be left out that is null or empty. Members of
/// these names, at any depth, are not compared: their readers may say the same in other words.
void require_agreement(const Json& given, const Json& written,
                       const std::vector<std::string>& in_other_words);

/// Reads a document, as `rewrite(json)`, which reads and is JSON again. Nothing if it is refused; else what
/// is written holds finite numbers alone, and is the same when it is read and written once more.
template <class Rewrite>
std::optional<Json> written_again(const Json& given, const Rewrite& rewrite) {
  Json written, again;
  if (!accepts([&] { written = rewrite(given); })) return std::nullopt;
  const std::string text = dump_json(written);  // throws if a number is not finite
  require(accepts([&] { again = rewrite(parse_json(text, "written")); }), "what is written can be read");
  require(again == written, "a document read and written twice stays the same");
  return written;
}

/// The same of a text; it may be no JSON.
template <class Rewrite>
void require_rewritten_alike(const std::string& text, const std::vector<std::string>& in_other_words,
                             const Rewrite& rewrite) {
  Json given;
  if (!accepts([&] { given = parse_json(text, "given"); })) return;
  if (const auto written = written_again(given, rewrite)) require_agreement(given, *written, in_other_words);
}

}  // namespace beadswim
