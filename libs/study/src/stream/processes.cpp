#include <fmt/core.h>
#include <poll.h>
#include <sched.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "beadswim/core/error.hpp"
#include "stream/results_in_order.hpp"

namespace beadswim {
namespace {

// send() and receive() return false if the other process has ended.
bool send(int socket, const void* bytes, std::size_t size) {
  return ::send(socket, bytes, size, MSG_NOSIGNAL) == static_cast<ssize_t>(size);
}
bool receive(int socket, void* bytes, std::size_t size) {
  return ::recv(socket, bytes, size, MSG_WAITALL) == static_cast<ssize_t>(size);
}

/// A process that works on one member after the other.
struct Worker {
  pid_t process = -1;
  int socket = -1;  ///< connection of this process with the worker
  int number = 0;   ///< member on which the process works; 0: idle
};

/// Processes that receive numbers of members and send results.
class Workers {
 public:
  Workers(int count, std::function<std::string(int)> work) : work_(std::move(work)), workers_(count) {
    for (Worker& worker : workers_) start(worker);
  }
  ~Workers() {
    for (Worker& worker : workers_) end(worker);
  }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Gives a member to each idle worker, while there are any after the member number `given`.
  void give(int& given, int count) {
    for (Worker& worker : workers_) {
      if (worker.number > 0 || given == count) continue;
      worker.number = ++given;
      send(worker.socket, &given, sizeof(given));
    }
  }

  /// Waits for the next result. Returns it after the number of its member; without bytes if the process
  /// ended.
  std::pair<int, std::string> next() {
    std::vector<pollfd> sockets;
    for (const Worker& worker : workers_)
      sockets.push_back({.fd = worker.number > 0 ? worker.socket : -1, .events = POLLIN, .revents = 0});
    while (::poll(sockets.data(), sockets.size(), -1) < 0) {
      if (errno != EINTR)
        throw SolverError(fmt::format("waiting for a process failed: {}", std::strerror(errno)));
    }
    const auto ready = std::ranges::find_if(sockets, [](const pollfd& each) { return each.revents != 0; });
    Worker& worker = workers_.at(ready - sockets.begin());
    std::pair<int, std::string> result{std::exchange(worker.number, 0), {}};
    if (std::size_t size = 0; receive(worker.socket, &size, sizeof(size))) {
      result.second.resize(size);
      if (receive(worker.socket, result.second.data(), size)) return result;
    }
    end(worker);
    start(worker);
    return {result.first, {}};
  }

 private:
  void start(Worker& worker) {
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0)
      throw SolverError(fmt::format("a process cannot be started: {}", std::strerror(errno)));
    std::fflush(stdout);
    worker.process = ::fork();
    if (worker.process < 0) {
      const std::string reason = std::strerror(errno);
      for (const int socket : ends) ::close(socket);
      throw SolverError(
          fmt::format("a process cannot be started: {}; use fewer processes at the same time", reason));
    }
    if (worker.process == 0) {
      ::close(ends[0]);
      for (const Worker& other : workers_)
        if (other.socket >= 0) ::close(other.socket);
      work_until_end(ends[1]);
      ::_exit(0);
    }
    ::close(ends[1]);
    worker.socket = ends[0];
  }

  void work_until_end(int socket) const noexcept {
    for (int number = 0; receive(socket, &number, sizeof(number));) {
      const std::string bytes = work_(number);
      const std::size_t size = bytes.size();
      if (!send(socket, &size, sizeof(size)) || !send(socket, bytes.data(), size)) return;
    }
  }

  static void end(Worker& worker) {
    if (worker.socket >= 0) ::close(worker.socket);
    worker.socket = -1;
    if (worker.process > 0) ::waitpid(worker.process, nullptr, 0);
    worker.process = -1;
  }

  std::function<std::string(int)> work_;
  std::vector<Worker> workers_;
};

}  // namespace

StreamTally work_in_processes(const StoredStream& members, int processes,
                              const std::function<MemberResult(const StreamMember&)>& work,
                              const StreamSinks& sinks) {
  const auto work_on = [&](int number) {
    const StreamMember member = members.member(number);
    try {
      return to_bytes(number, work(member));
    } catch (const StoppedEarly&) {
      throw;
    } catch (const std::exception& error) {
      return to_bytes(number, failure_of(member, sinks.program, error.what()));
    }
  };
  ResultsInOrder results(sinks);
  StreamProgress progress(sinks.progress, members.size());
  const auto add = [&](int number, const std::string& bytes) {
    constexpr const char* reason = "the process ended; its memory may not have been sufficient";
    results.add(bytes.empty() ? to_bytes(number, failure_of(members.member(number), sinks.program, reason))
                              : bytes);
    progress.update(results.tally().taken);
  };
  processes = std::min(processes, members.size());
  if (processes == 1) {
    for (int number = 1; number <= members.size(); ++number) add(number, work_on(number));
    return results.tally();
  }
  Workers workers(processes, work_on);
  for (int given = 0; results.tally().taken < members.size();) {
    workers.give(given, members.size());
    const auto [number, bytes] = workers.next();
    add(number, bytes);
  }
  return results.tally();
}

int usable_processors() {
  cpu_set_t usable;
  return ::sched_getaffinity(0, sizeof(usable), &usable) == 0 ? CPU_COUNT(&usable) : 1;
}

}  // namespace beadswim
