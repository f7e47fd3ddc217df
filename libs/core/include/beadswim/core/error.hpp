#pragma once

#include <fmt/core.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace beadswim {

/// Exit statuses of all programs. They are explained in docs/exit-status.md.
enum class ExitStatus : int {
  fine = 0,
  negative_verdict = 1,
  bad_input = 2,
  failed = 3,
  stopped_early = 4,
};

enum class Setting : int;  // defined in setting.hpp

/// Error because of invalid input, which the user can correct. The message states the place, the fault and
/// the remedy. The program then ends with exit status 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;  ///< constructor from a complete message with place and remedy
  /// Constructs the message "SETTING: what_and_remedy". SETTING is the flag of the invalid setting. If
  /// the program has no flag for this setting, SETTING is its name in words.
  InputError(Setting setting, const std::string& what_and_remedy);
  /// Constructs the message "WHERE: what_and_remedy". `where` is a file, FILE:JSON-POINTER, or a flag of the
  /// program that throws.
  InputError(const std::string& where, const std::string& what_and_remedy)
      : std::runtime_error(where + ": " + what_and_remedy) {}
  /// Constructs one of these messages from a format of fmt and its values.
  template <class Where, class... Values>
  requires(sizeof...(Values) > 0)
      InputError(const Where& where, fmt::format_string<Values...> what_and_remedy, Values&&... values)
      : InputError(where, fmt::format(what_and_remedy, std::forward<Values>(values)...)) {}
};

/// Failure of the solver, or of input or output, during a run. The program then ends with exit status 3.
class SolverError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Invalid data in a file or in a message from another rank, for example because the file is damaged. The
/// message states what is wrong. The function that opens the file adds the remedy.
class DataError : public SolverError {
 public:
  using SolverError::SolverError;
  /// Constructs the message "PLACE: fault". `place` is a file or an object in a file.
  DataError(const std::string& place, const std::string& fault) : SolverError(place + ": " + fault) {}
};

/// Failure because a calculation has become unstable and has produced a non-finite number. The program then
/// ends with exit status 3.
class NotFiniteError : public SolverError {
 public:
  using SolverError::SolverError;
};

/// Stop of a run before its end by a speed limit, a time limit or a signal. The results until the stop are
/// valid. The program then ends with exit status 4.
class StoppedEarly : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Makes the use of closed standard streams fail; otherwise a file could take their numbers. Call it first.
void hold_closed_streams();

/// Writes text to stderr. Ignores write errors, because a closed or full stderr must not end a run.
void print_to_stderr(const std::string& text);

/// Prints "PROGRAM: message" of the current exception on stderr. Returns the exit status that belongs to this
/// exception. Must be called inside a catch block.
int report_current_exception(const std::string& program);

}  // namespace beadswim
