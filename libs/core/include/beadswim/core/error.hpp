#pragma once

#include <stdexcept>
#include <string>

namespace beadswim {

/// Exit statuses of all programs. They are explained in docs/exit-status.md.
enum class ExitStatus : int {
  fine = 0,
  negative_verdict = 1,
  bad_input = 2,
  failed = 3,
  stopped_early = 4,
};

enum class Setting : int;  // setting.hpp

/// Invalid input, which the user can correct. The message states the place, the fault and the remedy. Exit
/// status 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;  ///< constructor from a complete message with place and remedy
  /// Begins the message with the name of the invalid setting. The name is a flag if the program has a flag
  /// for the setting, otherwise words.
  InputError(Setting setting, const std::string& what_and_remedy);
  /// Begins the message with `where`: a file, FILE:JSON-POINTER, or a flag of the program that throws.
  InputError(const std::string& where, const std::string& what_and_remedy)
      : std::runtime_error(where + ": " + what_and_remedy) {}
};

/// Failure of the solver, or of input or output, during a run. Exit status 3.
class SolverError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Failure because a calculation has become unstable and has produced a non-finite number. Exit status 3.
class NotFiniteError : public SolverError {
 public:
  using SolverError::SolverError;
};

/// Stop of a run before its end by a speed limit, a time limit or a signal. The results until the stop are
/// valid. Exit status 4.
class StoppedEarly : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Writes text to stderr. Ignores write errors, because a closed or full stderr must not end a run.
void print_to_stderr(const std::string& text);

/// Prints "PROGRAM: message" of the current exception on stderr and returns its exit status. Must be called
/// inside a catch block.
int report_current_exception(const std::string& program);

}  // namespace beadswim
