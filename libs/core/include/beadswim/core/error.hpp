#pragma once

#include <stdexcept>
#include <string>

namespace beadswim {

/// Exit statuses of every program (the table in docs/exit-status.md).
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
  using std::runtime_error::runtime_error;  ///< takes a complete message, which includes the place
  /// The message begins with the name of the invalid setting: words, or the flag in a program that has one.
  InputError(Setting setting, const std::string& what_and_remedy);
  /// `where` is a file, FILE:JSON-POINTER, or a flag of the program that throws.
  InputError(const std::string& where, const std::string& what_and_remedy)
      : std::runtime_error(where + ": " + what_and_remedy) {}
};

/// Failure of the solver, or of input or output, during a run. Exit status 3.
class SolverError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A non-finite number in a calculation, which has therefore become unstable. Exit status 3.
class NotFiniteError : public SolverError {
 public:
  using SolverError::SolverError;
};

/// Intended stop of a run with intact results: speed limit, time limit or signal. Exit status 4.
class StoppedEarly : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Writes text to stderr. Ignores write errors, because a closed or full stderr must not end a run.
void print_to_stderr(const std::string& text);

/// Prints "PROGRAM: message" of the current exception on stderr and returns its exit status. To be called
/// inside a catch block.
int report_current_exception(const std::string& program);

}  // namespace beadswim
