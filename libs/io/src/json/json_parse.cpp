#include <fmt/core.h>

#include <algorithm>
#include <unordered_set>

#include "beadswim/core/error.hpp"
#include "beadswim/io/json.hpp"

template class nlohmann::basic_json<nlohmann::ordered_map>;

namespace beadswim {
namespace {

/// Returns "line L, column C" for the byte with the number `byte`. All three numbers start at 1, as in
/// nlohmann-json.
std::string line_and_column(const std::string& text, std::size_t byte) {
  const std::size_t before = std::min(byte > 0 ? byte - 1 : 0, text.size());
  const auto line = std::count(text.begin(), text.begin() + before, '\n') + 1;
  const std::size_t line_start = before == 0 ? std::string::npos : text.rfind('\n', before - 1);
  const std::size_t column = line_start == std::string::npos ? before + 1 : before - line_start;
  return fmt::format("line {}, column {}", line, column);
}

/// Returns true if the parser stopped inside NaN, inf or infinity, which some programs write for non-finite
/// numbers.
bool stopped_at_non_finite_word(const std::string& text, std::size_t byte) {
  const std::string delimiters = " \t\r\n,:[]{}\"";
  const std::size_t last = text.find_last_of(delimiters, byte > 1 ? byte - 2 : 0);
  const std::size_t start = last == std::string::npos ? 0 : last + 1;
  std::string word = text.substr(start, text.find_first_of(delimiters, start) - start);
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
  if (!word.empty() && (word[0] == '-' || word[0] == '+')) word.erase(0, 1);
  return word == "nan" || word == "inf" || word == "infinity";
}

/// Returns an explanation of a syntax error: for common errors a specific text, otherwise the message of the
/// parser without its prefix.
std::string explanation(const std::string& text, std::size_t byte, const std::string& parser_message) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    return "the input is empty; a JSON document is needed";
  if (stopped_at_non_finite_word(text, byte))
    return "NaN and infinity are not JSON; a finite number is needed";
  if (byte >= text.size()) {
    return "the text ends before the JSON document is complete; is the file truncated?";
  }
  const std::size_t column = parser_message.find("column ");
  const std::size_t colon = parser_message.find(": ", column == std::string::npos ? 0 : column);
  return colon == std::string::npos ? parser_message : parser_message.substr(colon + 2);
}

/// Upper bound of the nesting depth. Deeper documents could overflow the stack of recursive functions.
constexpr std::size_t max_levels = 200;

/// Builds a document from the events of the parser. Throws InputError for a duplicate key. The builder of
/// nlohmann-json would keep the last value without an error.
class DocumentBuilder : public nlohmann::json_sax<Json> {
 public:
  DocumentBuilder(const std::string& text, const std::string& source) : text_(text), source_(source) {}

  Json take() { return std::move(root_); }

  bool null() override { return add(nullptr), true; }
  bool boolean(bool value) override { return add(value), true; }
  bool number_integer(number_integer_t value) override { return add(value), true; }
  bool number_unsigned(number_unsigned_t value) override { return add(value), true; }
  bool number_float(number_float_t value, const string_t&) override { return add(value), true; }
  bool string(string_t& value) override { return add(std::move(value)), true; }
  bool binary(binary_t& value) override { return add(std::move(value)), true; }
  bool start_object(std::size_t) override { return open(Json::object()), keys_.emplace_back(), true; }
  bool start_array(std::size_t) override { return open(Json::array()), true; }
  bool end_object() override { return open_.pop_back(), keys_.pop_back(), true; }
  bool end_array() override { return open_.pop_back(), true; }

  bool key(string_t& key) override {
    auto& members = open_.back()->get_ref<Json::object_t&>();
    if (!keys_.back().insert(key).second) {
      throw InputError(source_ + ":" + open_pointer() + pointer_step(key),
                       "this key is given twice in one object; remove one of the two entries");
    }
    members.emplace_back(std::move(key), nullptr);
    return true;
  }

  bool parse_error(std::size_t byte, const std::string& token, const Json::exception& error) override {
    constexpr int number_overflow = 406;
    const std::string what =
        error.id == number_overflow ? fmt::format("the number {} is beyond the range of a double", token)
        : is_second_document(byte)  ? "a second JSON document begins here, but only one document is read; "
                                      "write one document per line (JSON Lines), or select one document, for "
                                      "example with jq"
                                    : explanation(text_, byte, error.what());
    throw InputError(source_, line_and_column(text_, byte) + ": " + what);
  }

 private:
  /// Returns true if the parser stopped at an object or array after the end of the document.
  bool is_second_document(std::size_t byte) const {
    const bool is_document_complete = open_.empty() && (root_.is_object() || root_.is_array());
    return is_document_complete && byte > 0 && byte <= text_.size() &&
           (text_[byte - 1] == '{' || text_[byte - 1] == '[');
  }

  void open(Json container) {
    if (open_.size() == max_levels)
      throw InputError(source_,
                       "the document is nested more than {} levels deep, deeper than any layout, record or "
                       "prediction; give another file",
                       max_levels);
    open_.push_back(add(std::move(container)));
  }

  /// Appends a value to the open array, or assigns it to the last key of the open object. Returns a pointer
  /// to the value. The pointer remains valid until the value is complete, because until then values are added
  /// only inside it.
  Json* add(Json value) {
    if (open_.empty()) return &(root_ = std::move(value));
    if (open_.back()->is_array()) {
      auto& elements = open_.back()->get_ref<Json::array_t&>();
      return &elements.emplace_back(std::move(value));
    }
    Json& member = open_.back()->get_ref<Json::object_t&>().back().second;
    return &(member = std::move(value));
  }

  /// Returns the JSON pointer to the innermost open container.
  std::string open_pointer() const {
    std::string pointer;
    for (std::size_t depth = 0; depth + 1 < open_.size(); ++depth) {
      const Json& container = *open_[depth];
      pointer += container.is_array() ? fmt::format("/{}", container.size() - 1)
                                      : pointer_step(container.get_ref<const Json::object_t&>().back().first);
    }
    return pointer;
  }

  const std::string& text_;
  const std::string& source_;
  Json root_;
  std::vector<Json*> open_;
  std::vector<std::unordered_set<std::string>> keys_;  ///< keys of each open object, for a fast search
};

/// Throws InputError if the text is UTF-16 or has a NUL character, which the parser takes for the end.
void require_no_nul(const std::string& text, const std::string& source) {
  const bool has_mark = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
  const std::size_t nul = has_mark ? 0 : text.find('\0');
  if (nul == std::string::npos) return;
  throw InputError(
      source, line_and_column(text, nul + 1) +
                  (nul < 2 ? ": the text is not UTF-8, but probably UTF-16; convert it, for example with "
                             "iconv -f UTF-16 -t UTF-8"
                           : ": the text contains a NUL character; is the file damaged?"));
}

}  // namespace

Json parse_json(const std::string& text, const std::string& source) {
  if (text.starts_with("\x89HDF")) {
    throw InputError(source,
                     "the file is an HDF5 file, like a trajectory; give a JSON document: layout, run record "
                     "or prediction");
  }
  require_no_nul(text, source);
  DocumentBuilder builder(text, source);
  Json::sax_parse(text, &builder);
  return builder.take();
}

}  // namespace beadswim
