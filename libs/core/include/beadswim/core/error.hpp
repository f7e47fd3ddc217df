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

/// Input that a user can mend: says where it is wrong, what is wrong, and what to do. Exit status 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;  ///< of a message that has its place
  /// The setting that is wrong is named in words, or by its flag in a program that has one.
  InputError(Setting setting, const std::string& what_and_remedy);
  /// where: a file, FILE:JSON-POINTER, or a flag of the program that throws.
  InputError(const std::string& where, const std::string& what_and_remedy)
      : std::runtime_error(where + ": " + what_and_remedy) {}
};

/// The solver or I/O failed after work began. Exit status 3.
class SolverError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A number that should be finite is not: the calculation has become unstable. Exit status 3.
class NotFiniteError : public SolverError {
 public:
  using SolverError::SolverError;
};

/// Stopped on purpose, results intact (speed limit, time limit, signal). Exit status 4.
class StoppedEarly : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Writes to stderr; a stderr that is closed or full is no reason to fail.
void tell(const std::string& text);

/// The exit status that an exception in flight stands for; call inside a catch block.
/// Prints "PROGRAM: message" on stderr.
int report_current_exception(const std::string& program);

}  // namespace beadswim
