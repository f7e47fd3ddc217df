#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "beadswim/core/error.hpp"
#include "beadswim/core/temporary_file.hpp"
#include "beadswim/figure/drawing.hpp"

extern char** environ;

namespace beadswim {
namespace {

/// Runs a command with `input` as its stdin and `output` as its stdout. Returns its exit status, or -1 if a
/// signal ended it. `what_for` is the place that an error message names.
int run_filter(const std::string& what_for, char* const* command, std::FILE* input, std::FILE* output) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(input), 0);
  posix_spawn_file_actions_adddup2(&actions, fileno(output), 1);
  pid_t child = 0;
  const int fault = posix_spawnp(&child, command[0], &actions, nullptr, command, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (fault != 0) {
    throw InputError(what_for,
                     "the program {} cannot be started: {}; install the package librsvg2-bin, or write .svg",
                     command[0], std::strerror(fault));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

std::string converted_svg(const std::string& svg, const std::string& path) {
  const OpenFile input = temporary_file(), output = temporary_file();
  append(input, svg);
  std::rewind(input.get());
  const bool is_pdf = path.ends_with(".pdf");
  std::string program = "rsvg-convert", zoom = is_pdf ? "--zoom=1" : "--zoom=2",
              format = is_pdf ? "--format=pdf" : "--format=png";
  const std::array<char*, 4> command{program.data(), zoom.data(), format.data(), nullptr};
  if (const int status = run_filter(path, command.data(), input.get(), output.get())) {
    throw SolverError(
        fmt::format("{}: the program rsvg-convert failed with status {}; write .svg instead", path, status));
  }
  return read_all(output);
}

}  // namespace beadswim
