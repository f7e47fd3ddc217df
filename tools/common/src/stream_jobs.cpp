#include "beadswim/tools/stream_jobs.hpp"

#include <fmt/core.h>
#include <poll.h>
#include <sched.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <vector>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

/// Sends `size` bytes. Returns false if the other process has ended.
bool send_all(int socket, const void* bytes, std::size_t size) {
  const char* rest = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t sent = ::send(socket, rest, size, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    rest += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}

/// Receives `size` bytes. Returns false if the other process has ended.
bool receive_all(int socket, void* bytes, std::size_t size) {
  char* rest = static_cast<char*>(bytes);
  while (size > 0) {
    const ssize_t received = ::recv(socket, rest, size, 0);
    if (received < 0 && errno == EINTR) continue;
    if (received <= 0) return false;
    rest += received;
    size -= static_cast<std::size_t>(received);
  }
  return true;
}

bool send_text(int socket, const std::string& text) {
  const std::size_t size = text.size();
  return send_all(socket, &size, sizeof(size)) && send_all(socket, text.data(), size);
}

bool receive_text(int socket, std::string& text) {
  std::size_t size = 0;
  if (!receive_all(socket, &size, sizeof(size))) return false;
  text.resize(size);
  return receive_all(socket, text.data(), size);
}

/// A process that works on one document after the other.
struct Worker {
  pid_t process = -1;
  int socket = -1;                       ///< connection of this process with the worker
  std::optional<StreamMember> member{};  ///< document on which the worker works; nullopt: idle
};

class Workers {
 public:
  using Work = std::function<MemberResult(const StreamMember&)>;

  Workers(int count, const Work& work) : work_(work), workers_(count) {
    for (Worker& worker : workers_) start(worker);
  }
  ~Workers() {
    for (Worker& worker : workers_) end(worker);
  }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  Worker* idle() {
    const auto found = std::ranges::find_if(workers_, [](const Worker& w) { return !w.member; });
    return found == workers_.end() ? nullptr : &*found;
  }

  /// Gives the worker the document. Its result follows from collect(), also if the process has ended.
  static void give(Worker& worker, StreamMember member) {
    send_text(worker.socket, member.source) && send_text(worker.socket, member.text) &&
        send_all(worker.socket, &member.number, sizeof(member.number));
    worker.member = std::move(member);
  }

  struct Collected {
    StreamMember member;
    std::optional<MemberResult> result;
  };

  /// Waits until at least one worker has ended its work, and returns the results.
  std::vector<Collected> collect() {
    std::vector<pollfd> sockets;
    for (const Worker& worker : workers_) sockets.push_back({worker.member ? worker.socket : -1, POLLIN, 0});
    while (::poll(sockets.data(), sockets.size(), -1) < 0) {
      if (errno != EINTR)
        throw SolverError(fmt::format("waiting for a process failed: {}", std::strerror(errno)));
    }
    std::vector<Collected> results;
    for (std::size_t w = 0; w < workers_.size(); ++w) {
      if (sockets[w].revents == 0) continue;
      Worker& worker = workers_[w];
      Collected& collected = results.emplace_back(Collected{std::move(*worker.member), MemberResult{}});
      worker.member.reset();
      MemberResult& result = *collected.result;
      if (receive_all(worker.socket, &result.state, sizeof(result.state)) &&
          receive_text(worker.socket, result.text))
        continue;
      collected.result.reset();
      end(worker);
      start(worker);
    }
    return results;
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
      throw SolverError(fmt::format("a process cannot be started: {}; use fewer --jobs", reason));
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

  void work_until_end(int socket) const {
    StreamMember member;
    while (receive_text(socket, member.source) && receive_text(socket, member.text) &&
           receive_all(socket, &member.number, sizeof(member.number))) {
      const MemberResult result = work_(member);
      if (!send_all(socket, &result.state, sizeof(result.state)) || !send_text(socket, result.text)) return;
    }
  }

  static void end(Worker& worker) {
    if (worker.socket >= 0) ::close(worker.socket);
    worker.socket = -1;
    if (worker.process > 0) ::waitpid(worker.process, nullptr, 0);
    worker.process = -1;
  }

  const Work& work_;
  std::vector<Worker> workers_;
};

}  // namespace

void for_each_member(
    DocumentStream& stream, int jobs, const std::function<MemberResult(const StreamMember&)>& work,
    const std::function<void(const StreamMember&, const std::optional<MemberResult>&)>& take) {
  if (jobs == 1) {
    while (const auto member = stream.next()) take(*member, work(*member));
    return;
  }
  Workers workers(jobs, work);
  std::map<int, Workers::Collected> waiting;  // for an earlier result, by number
  int given = 0, taken = 0;
  for (bool is_at_end = false; !is_at_end || taken < given;) {
    while (Worker* idle = is_at_end || given - taken >= 4 * jobs ? nullptr : workers.idle()) {
      std::optional<StreamMember> member = stream.next();
      is_at_end = !member;
      if (is_at_end) break;
      given = member->number;
      Workers::give(*idle, std::move(*member));
    }
    if (taken == given) continue;
    for (Workers::Collected& collected : workers.collect()) {
      const int number = collected.member.number;
      waiting.emplace(number, std::move(collected));
    }
    for (auto next = waiting.begin(); next != waiting.end() && next->first == taken + 1;
         next = waiting.erase(next)) {
      take(next->second.member, next->second.result);
      ++taken;
    }
  }
}

int usable_processors() {
  cpu_set_t usable;
  return ::sched_getaffinity(0, sizeof(usable), &usable) == 0 ? CPU_COUNT(&usable) : 1;
}

void StreamProgress::update(double done, int before) {
  const Clock::time_point now = Clock::now();
  if (now - last_ < std::chrono::seconds(10)) return;
  last_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double own = done - before;
  const std::string left =
      own > 0 ? fmt::format(", about {:.0f} s left", seconds / own * (count_ - done)) : "";
  const std::string parts = fmt::format("{:.{}f}", done, done == std::floor(done) ? 0 : 1);
  print_to_stderr(fmt::format("{}: {} of {} {} done{}\n", program_, parts, count_, what_, left));
}

}  // namespace beadswim
