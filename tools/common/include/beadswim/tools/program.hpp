#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/error.hpp"
#include "beadswim/io/json.hpp"

// What all programs share at their command line.

namespace beadswim {

/// A CLI11 application set up as every program of ours: --help, --version, defaults shown. From here on
/// messages of the libraries name flags.
std::unique_ptr<CLI::App> make_program(const std::string& name, const std::string& description);

/// Starts a group of flags in the help of a command: the flags added from here on, until the next group.
void begin_group(CLI::App& command, const std::string& title);

/// Breaks a text into lines as long as those of the help, each after `indent` spaces.
std::string wrapped(const std::string& text, std::size_t indent);

/// "beadswim-layout swimmer"
std::string full_name(const CLI::App& command);

/// Ends the help of a command with examples, which are lines for a shell, and the page of docs/ to read next.
/// tests/cli/examples.sh runs all examples.
void set_footer(CLI::App& command, const std::vector<std::string>& examples, const std::string& page);

/// The body of main(): runs `run` and returns its exit status, or that of the exception that it ends with,
/// which is told on stderr under the program's name.
template <typename Run>
int guarded_main(const char* name, const Run& run) {
  try {
    return run();
  } catch (...) {
    return report_current_exception(name);
  }
}

/// Parses the command line. Returns an exit status if the program is done (--help, --version printed on
/// stdout); throws InputError for a wrong command line, naming flag, value, what is allowed and, for an
/// unknown flag, the nearest valid one.
std::optional<int> parse_command_line(CLI::App& program, int argc, const char* const* argv);

/// Validators with readable messages (CLI11's own accept NaN and print 300-digit ranges).
CLI::Validator finite();
CLI::Validator finite_positive();
CLI::Validator finite_non_negative();
CLI::Validator number_between(double low, double high);
CLI::Validator whole_number(std::int64_t low, std::int64_t high);
CLI::Validator whole_positive();     ///< up to a million
CLI::Validator product_tolerance();  ///< of mobility products

/// For a flag whose value is a word.
CLI::Validator one_of(std::vector<std::string> words);

/// For a flag, held as text, of several numbers joined by commas, such as "4" or "3,4,5": how many it may
/// have, any number if none is named, and what each must be.
CLI::Validator number_list(std::vector<std::size_t> counts, CLI::Validator each);

/// The parts of such a text; one, empty, of an empty one.
std::vector<std::string> split_at_commas(const std::string& text);

/// The numbers of such a text.
std::vector<double> parse_numbers(const std::string& text);
std::vector<int> parse_whole_numbers(const std::string& text);

/// Throws InputError if an output is to replace an input: both names mean one file.
void require_other_file(const std::string& input, const std::string& output);

/// One provenance record: { "program", "version", "revision", "arguments" }. `arguments` are the flags that
/// were given, with their values; input and output file names are left out, so that a pipe and a file give
/// the same bytes.
Json provenance_record(const CLI::App& program);

}  // namespace beadswim
