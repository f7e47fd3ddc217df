#include "beadswim/core/error.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <new>

#include "beadswim/core/setting.hpp"

namespace beadswim {

InputError::InputError(Setting setting, const std::string& what_and_remedy)
    : InputError(name_of(setting), what_and_remedy) {}

void hold_closed_streams() {
  for (const int stream : {0, 1, 2})  // open() takes the lowest free number
    if (fcntl(stream, F_GETFD) < 0) open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

void print_to_stderr(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

int report_current_exception(const std::string& program) {
  const auto say = [&program](const std::exception& error, ExitStatus status) {
    print_to_stderr(fmt::format("{}: {}\n", program, error.what()));
    return static_cast<int>(status);
  };
  try {
    throw;
  } catch (const InputError& error) {
    return say(error, ExitStatus::bad_input);
  } catch (const StoppedEarly& error) {
    return say(error, ExitStatus::stopped_early);
  } catch (const std::bad_alloc&) {
    print_to_stderr(
        fmt::format("{}: out of memory; use fewer swimmers or lattice cells, a machine with more memory, or "
                    "a higher limit (ulimit -v)\n",
                    program));
    return static_cast<int>(ExitStatus::failed);
  } catch (const std::exception& error) {
    return say(error, ExitStatus::failed);
  }
}

}  // namespace beadswim
