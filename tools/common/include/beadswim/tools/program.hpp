#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/error.hpp"
#include "beadswim/io/json.hpp"

// Command-line handling of all programs: setup, help, parsing, checks of values, and the record of the
// command line (provenance).

namespace beadswim {

/// Returns the format of the help that make_program() sets.
std::shared_ptr<CLI::FormatterBase> help_formatter();

/// Returns a CLI11 application with --help and --version, whose help shows default values. After this call,
/// error messages of the libraries name a setting by its flag, for example --relaxation-time.
std::unique_ptr<CLI::App> make_program(const std::string& name, const std::string& description);

/// Begins a group of flags in the help of a command. All flags that are added before the next call belong to
/// this group.
void begin_group(CLI::App& command, const std::string& title);

/// Breaks a text into lines of at most 100 characters, the line length of the help. Indents each line by
/// `indent` spaces.
std::string wrapped(const std::string& text, std::size_t indent);

/// Returns the name of a command with the name of its program before it, for example "beadswim-layout
/// swimmer".
std::string full_name(const CLI::App& command);

/// Adds examples and a page of documentation to the end of a command's help. `examples`: command lines for a
/// shell; tests/cli/examples.sh runs them. `page`: path relative to docs/.
void set_footer(CLI::App& command, const std::vector<std::string>& examples, const std::string& page);

/// Calls `run` and returns its exit status. If `run` throws an exception, prints the name of the program and
/// the message of the exception on standard error, and returns the exit status for this type of exception.
/// main() consists of this call.
template <typename Run>
int guarded_main(const char* name, const Run& run) {
  hold_closed_streams();
  try {
    return run();
  } catch (...) {
    return report_current_exception(name);
  }
}

/// Parses the command line. For --help and --version, prints the requested text to standard output and
/// returns an exit status; otherwise returns nullopt. Throws InputError if the command line is invalid. The
/// error message states the flag, its value and the allowed values; for an unknown flag, it suggests the flag
/// with the most similar name.
std::optional<int> parse_command_line(CLI::App& program, int argc, const char* const* argv);

// Validators of flag values. The validators of CLI11 are not used, because they accept NaN and print ranges
// with up to 300 digits.
CLI::Validator finite();
CLI::Validator finite_positive();
CLI::Validator finite_non_negative();
CLI::Validator number_between(double low, double high);
CLI::Validator fraction();  ///< above 0 and below 1
/// A finite number of radians, or of degrees with the ending deg, such as 90deg, that is not below `min`.
CLI::Validator angle(double min = -HUGE_VAL);
CLI::Validator whole_number(std::int64_t low, std::int64_t high);
CLI::Validator whole_positive();  ///< from 1 to 10^6

/// Returns a validator of a flag whose value is one of `words`.
CLI::Validator one_of(std::vector<std::string> words);

/// Returns a validator of a list of values joined by commas, such as "4" or "3,4,5". `counts`: allowed
/// numbers of values; if empty, every number is allowed. `each`: validator of one value.
CLI::Validator number_list(std::vector<std::size_t> counts, CLI::Validator each);

/// Returns the parts of a text between its commas.
std::vector<std::string> split_at_commas(const std::string& text);

/// Returns the numbers in a text of numbers joined by commas. The validator number_list() must have accepted
/// the text.
std::vector<double> parse_numbers(const std::string& text);
double parse_angle(const std::string& text);  ///< of the form that angle() accepts [radian]

/// Throws InputError if both paths name the same file, because writing the output would destroy the input.
void require_other_file(const std::string& input, const std::string& output);

/// Throws InputError if the path, value of the flag, does not end in .csv and is not "-" (standard output).
void require_csv_path(const std::string& path, const std::string& flag);

/// Prints how many of `documents` have no result, if there are any. Throws InputError if none has.
void report_left_out(const char* program, int left_out, int documents);

/// Returns the record of this run of the program (provenance): { "program", "version", "revision",
/// "arguments" }. The arguments are the flags of the command line with their values. Names of input and
/// output files are omitted, so that a document does not depend on whether its input came from a pipe or from
/// a file.
Json provenance_record(const CLI::App& program);

}  // namespace beadswim
