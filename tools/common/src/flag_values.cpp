#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <ranges>

#include "beadswim/core/joined.hpp"
#include "beadswim/core/names.hpp"
#include "beadswim/tools/program.hpp"

namespace beadswim {
namespace {

/// Returns a pointer to the text after a leading plus sign, because std::from_chars rejects a plus sign.
const char* first_digit(const std::string& text) {
  const bool has_plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  return text.data() + (has_plus ? 1 : 0);
}

/// Converts a text to a number. Returns nullopt if the text contains anything but a number. Returns infinity
/// if the number is too large for a double.
std::optional<double> parse_number(const std::string& text) {
  const char* const last = text.data() + text.size();
  double value = 0;
  const auto [end, error] = std::from_chars(first_digit(text), last, value);
  if (end != last || error == std::errc::invalid_argument) return std::nullopt;
  return error == std::errc::result_out_of_range ? HUGE_VAL : value;
}

/// Returns the text without the ending, if it has this ending.
std::string without_ending(const std::string& text, const std::string& ending) {
  return text.ends_with(ending) ? text.substr(0, text.size() - ending.size()) : text;
}

/// Returns an addition to an error message if the text is a percentage such as "5 %": the number to write
/// instead (0.05). Returns an empty text otherwise.
std::string percentage_hint(const std::string& text) {
  const bool is_percentage = text.ends_with("%");
  const auto number = parse_number(text.substr(0, text.find_last_not_of(" %") + 1));
  if (!is_percentage || !number || !std::isfinite(*number)) return "";
  return fmt::format("; write {:g} % as {:g}", *number, *number / 100);
}

/// Returns a validator that accepts finite numbers for which `condition` is true. `allowed` describes these
/// numbers in error messages.
CLI::Validator number_that(const std::function<bool(double)>& condition, const std::string& allowed) {
  const auto fault = [condition, allowed](const std::string& text) {
    const std::optional<double> value = parse_number(text);
    const bool fine = value && std::isfinite(*value) && condition(*value);
    return fine ? std::string{} : fmt::format("\"{}\": {}{}", text, allowed, percentage_hint(text));
  };
  return CLI::Validator(fault, "");
}

}  // namespace

CLI::Validator finite() {
  return number_that([](double) { return true; }, "the value must be a finite number");
}

CLI::Validator finite_positive() {
  return number_that([](double x) { return x > 0; }, "the value must be a finite number greater than 0");
}

CLI::Validator fraction() {
  return number_that([](double x) { return x > 0 && x < 1; },
                     "the value must be a number above 0 and below 1; 0.05 means 5 %");
}

CLI::Validator angle(double min) {
  const auto fault = [min](const std::string& text) {
    const std::optional<double> value = parse_number(without_ending(text, "deg"));
    if (value && *value < min) return fmt::format("\"{}\": the angle must be {} or greater", text, min);
    return value && std::isfinite(*value)
               ? std::string{}
               : fmt::format(
                     "\"{}\": the value must be a finite number of radians, or of degrees such as 90deg",
                     text);
  };
  return CLI::Validator(fault, "");
}

CLI::Validator whole_number(std::int64_t low, std::int64_t high) {
  const auto fault = [low, high](const std::string& text) {
    std::int64_t value = 0;
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(first_digit(text), last, value);
    const bool is_number = error == std::errc{} && end == last;
    const bool fine = is_number && value >= low && value <= high;
    return fine ? std::string{}
                : fmt::format("\"{}\": the value must be a whole number from {} to {}", text, low, high);
  };
  return CLI::Validator(fault, "");
}

CLI::Validator whole_positive() {
  return whole_number(1, 1000000);
}

CLI::Validator number_between(double low, double high) {
  return number_that([low, high](double x) { return x >= low && x <= high; },
                     fmt::format("the value must be a number from {} to {}", low, high));
}

CLI::Validator finite_non_negative() {
  return number_that([](double x) { return x >= 0; }, "the value must be a finite number, 0 or greater");
}

CLI::Validator number_list(std::vector<std::size_t> counts, CLI::Validator each) {
  const auto fault = [counts = std::move(counts), each = std::move(each)](const std::string& text) {
    const std::vector<std::string> parts = split_at_commas(text);
    if (!counts.empty() && std::ranges::find(counts, parts.size()) == counts.end()) {
      return fmt::format("\"{}\" has {} values, but {} are needed, separated by commas", text, parts.size(),
                         joined(counts, " or "));
    }
    std::string fault_of_part;
    for (auto part = parts.begin(); part != parts.end() && fault_of_part.empty(); ++part)
      fault_of_part = each(*part);
    return fault_of_part;
  };
  return CLI::Validator(fault, "");
}

CLI::Validator one_of(std::vector<std::string> words) {
  const auto fault = [words = std::move(words)](const std::string& text) {
    return std::ranges::find(words, text) != words.end() ? std::string{} : format_unknown_name(text, words);
  };
  return CLI::Validator(fault, "");
}

std::vector<std::string> split_at_commas(const std::string& text) {
  return split_at(',', text);
}

std::vector<double> parse_numbers(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& part : split_at_commas(text)) numbers.push_back(parse_number(part).value());
  return numbers;
}

double parse_angle(const std::string& text) {
  const double value = parse_number(without_ending(text, "deg")).value();
  return text.ends_with("deg") ? value * std::numbers::pi / 180 : value;
}

}  // namespace beadswim
