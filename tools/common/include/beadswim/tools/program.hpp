#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/error.hpp"
#include "beadswim/io/json.hpp"

// Command line of all programs: setup, help, parsing, checks of values, provenance.

namespace beadswim {

/// Returns a CLI11 application with --help and --version, whose help shows default values. After this call,
/// messages of the libraries name settings by the flags of the programs.
std::unique_ptr<CLI::App> make_program(const std::string& name, const std::string& description);

/// Begins a group of flags in the help of a command. The group contains all flags that are added before the
/// next call.
void begin_group(CLI::App& command, const std::string& title);

/// Breaks a text into lines of at most 100 characters and indents each line by `indent` spaces. The help has
/// the same line length.
std::string wrapped(const std::string& text, std::size_t indent);

/// Returns the name of a command after the name of its program, for example "beadswim-layout swimmer".
std::string full_name(const CLI::App& command);

/// Adds examples and a page of documentation to the end of a command's help. `examples`: command lines for a
/// shell; tests/cli/examples.sh runs them. `page`: path relative to docs/.
void set_footer(CLI::App& command, const std::vector<std::string>& examples, const std::string& page);

/// Calls `run` and returns its exit status. If `run` throws, prints the exception after the program's name on
/// standard error and returns the exit status that belongs to the exception. main() consists of this call.
template <typename Run>
int guarded_main(const char* name, const Run& run) {
  try {
    return run();
  } catch (...) {
    return report_current_exception(name);
  }
}

/// Parses the command line. Returns an exit status if the program has only to print --help or --version,
/// which this function prints to standard output. Otherwise returns nullopt. Throws InputError if the command
/// line is invalid. The message states the flag, its value and the allowed values. For an unknown flag, the
/// message suggests the flag with the most similar name.
std::optional<int> parse_command_line(CLI::App& program, int argc, const char* const* argv);

// Validators of flag values. The validators of CLI11 accept NaN and print ranges with up to 300 digits.
CLI::Validator finite();
CLI::Validator finite_positive();
CLI::Validator finite_non_negative();
CLI::Validator number_between(double low, double high);
CLI::Validator whole_number(std::int64_t low, std::int64_t high);
CLI::Validator whole_positive();     ///< from 1 to 10^6
CLI::Validator product_tolerance();  ///< relative error of mobility products, from 1e-12 to 1e-2

/// Returns a validator of a flag whose value is one of `words`.
CLI::Validator one_of(std::vector<std::string> words);

/// Returns a validator of values joined by commas, such as "4" or "3,4,5". `counts`: allowed numbers of
/// values; if empty, all numbers are allowed. `each`: validator of each value.
CLI::Validator number_list(std::vector<std::size_t> counts, CLI::Validator each);

/// Returns the parts of a text between its commas. An empty text has one part, which is empty.
std::vector<std::string> split_at_commas(const std::string& text);

/// Return the numbers in a text of numbers joined by commas. number_list() must have accepted the text.
std::vector<double> parse_numbers(const std::string& text);
std::vector<int> parse_whole_numbers(const std::string& text);

/// Throws InputError if both paths lead to the same file, because the output would replace the input.
void require_other_file(const std::string& input, const std::string& output);

/// Returns the provenance record of the program: { "program", "version", "revision", "arguments" }. The
/// arguments are the flags of the command line with their values. Names of input and output files are
/// omitted, so that a document does not depend on whether it was read from a pipe or from a file.
Json provenance_record(const CLI::App& program);

}  // namespace beadswim
