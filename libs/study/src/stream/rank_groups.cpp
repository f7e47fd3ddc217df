#include "beadswim/study/rank_groups.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <thread>

#include "beadswim/core/error.hpp"
#include "beadswim/core/rank_failure.hpp"
#include "stream/results_in_order.hpp"

namespace beadswim {
namespace {

/// Counters on rank 0, which every rank may read and increase at any time.
class SharedCounters {
 public:
  enum Counter {
    claimed,  ///< members that a group has begun
    treated,  ///< millionths of members that have been treated
    stopped,  ///< ranks that have stopped
    number_of_counters
  };

  explicit SharedCounters(const Communicator& communicator) {
    long* memory = nullptr;
    const MPI_Aint bytes = communicator.is_root() ? number_of_counters * sizeof(long) : 0;
    MPI_Win_allocate(bytes, sizeof(long), MPI_INFO_NULL, communicator.get(), &memory, &window_);
    if (communicator.is_root()) std::fill_n(memory, number_of_counters, 0);
    MPI_Win_lock_all(0, window_);
    MPI_Win_sync(window_);
    MPI_Barrier(communicator.get());
  }
  ~SharedCounters() {
    MPI_Win_unlock_all(window_);
    MPI_Win_free(&window_);
  }
  SharedCounters(const SharedCounters&) = delete;
  SharedCounters& operator=(const SharedCounters&) = delete;

  long value(Counter counter) { return add(counter, 0); }
  /// Adds a number to a counter. Returns its former value.
  long add(Counter counter, long number) {
    long former = 0;
    MPI_Fetch_and_op(&number, &former, MPI_LONG, 0, counter, MPI_SUM, window_);
    MPI_Win_flush(0, window_);
    return former;
  }

 private:
  MPI_Win window_ = MPI_WIN_NULL;
};

/// Results on their way to rank 0. Neither side waits for the other, unless rank 0 is far behind.
class ResultMessages {
 public:
  explicit ResultMessages(const Communicator& communicator) : communicator_(communicator.get()) {}

  void send(std::string bytes) {
    Message& message = sent_.emplace_back(std::move(bytes));
    MPI_Issend(message.bytes.data(), static_cast<int>(message.bytes.size()), MPI_BYTE, 0, 0,
               communicator_.get(), &message.request);
    proceed();
  }

  /// Lets the results that this rank has sent proceed. Waits while more than `max_under_way` have not
  /// arrived.
  void proceed(std::size_t max_under_way = 100) {
    for (int has_arrived = 1; has_arrived && !sent_.empty();) {
      MPI_Request& request = sent_.front().request;
      if (sent_.size() > max_under_way)
        MPI_Wait(&request, MPI_STATUS_IGNORE);
      else
        MPI_Test(&request, &has_arrived, MPI_STATUS_IGNORE);
      if (has_arrived) sent_.pop_front();
    }
  }

  bool is_receiving() const { return received_.request != MPI_REQUEST_NULL; }

  /// Returns on rank 0 a result that has arrived; nullptr if there is none.
  const std::string* next() {
    if (!is_receiving()) {
      MPI_Message message = MPI_MESSAGE_NULL;
      MPI_Status status;
      int is_there = 0, size = 0;
      MPI_Improbe(MPI_ANY_SOURCE, 0, communicator_.get(), &is_there, &message, &status);
      if (!is_there) return nullptr;
      MPI_Get_count(&status, MPI_BYTE, &size);
      received_.bytes.resize(size);
      MPI_Imrecv(received_.bytes.data(), size, MPI_BYTE, &message, &received_.request);
    }
    int has_arrived = 0;
    MPI_Test(&received_.request, &has_arrived, MPI_STATUS_IGNORE);
    return has_arrived ? &received_.bytes : nullptr;
  }

 private:
  struct Message {
    std::string bytes;
    MPI_Request request = MPI_REQUEST_NULL;
  };

  Communicator communicator_;  // for nothing else
  std::deque<Message> sent_;
  Message received_;
};

/// Removes from the schedule the members with results of an earlier command. Returns which these are.
/// Collective.
std::vector<char> remove_earlier(StreamSchedule& schedule, int count, const StreamSinks& sinks,
                                 const Communicator& communicator) {
  std::vector<char> has_earlier(count);
  run_on_root(
      [&] {
        for (int number = 1; sinks.earlier && number <= count; ++number)
          has_earlier[number - 1] = sinks.earlier(number).has_value();
      },
      communicator);
  broadcast(has_earlier, communicator);
  for (std::vector<int>* numbers : {&schedule.side_by_side, &schedule.on_all_ranks})
    std::erase_if(*numbers, [&](int number) { return has_earlier[number - 1] != 0; });
  return has_earlier;
}

/// Work of all groups on the members of a stream.
class StreamOnRanks {
 public:
  using Work = std::function<MemberResult(const StreamMember&, const RankGroup&)>;

  /// `schedule`: without the members that have earlier results. Collective.
  StreamOnRanks(const StoredStream& members, const StreamSchedule& schedule, const Work& work,
                const StreamSinks& sinks, const Communicator& communicator)
      : members_(members),
        schedule_(schedule),
        work_(work),
        sinks_(sinks),
        communicator_(communicator),
        counters_(communicator),
        messages_(communicator),
        progress_(sinks.progress, members.size()) {}

  /// Collective.
  StreamTally run(std::vector<char> has_earlier) {
    StreamTally tally;
    try {
      num_earlier_ = static_cast<int>(std::ranges::count(has_earlier, 1));
      if (communicator_.is_root()) results_.emplace(sinks_, std::move(has_earlier));
      work_side_by_side(*group_of(schedule_, communicator_));
      for (const int number : schedule_.on_all_ranks) {
        if (is_to_stop(communicator_)) break;
        work_on(number, communicator_);
      }
      if (results_) tally = results_->tally();
    } catch (...) {
      if (sinks_.failure) sinks_.failure();
      throw;
    }
    tally.is_stopped = communicator_.is_root() && is_stopped();
    MPI_Bcast(&tally, sizeof(tally), MPI_BYTE, 0, communicator_.get());
    return tally;
  }

 private:
  static constexpr long whole = 1000000;  ///< a member [millionths]

  bool is_stopped() { return counters_.value(SharedCounters::stopped) > 0; }

  /// Stops all groups if this rank is to stop. Returns whether it has.
  bool stop_if_asked() {
    if (has_stopped_ || !sinks_.stop || !sinks_.stop()) return has_stopped_;
    counters_.add(SharedCounters::stopped, 1);
    return has_stopped_ = true;
  }

  /// Returns true, on all ranks of the group, if any group is to stop. Collective for the group.
  bool is_to_stop(const Communicator& ranks) {
    int is_over = stop_if_asked() || (ranks.is_root() && is_stopped());
    MPI_Allreduce(MPI_IN_PLACE, &is_over, 1, MPI_INT, MPI_MAX, ranks.get());
    return is_over != 0;
  }

  /// Works on the members that no other group has begun, then waits for the other groups. Collective.
  void work_side_by_side(const Communicator& ranks) {
    const int count = static_cast<int>(schedule_.side_by_side.size());
    while (!is_to_stop(ranks)) {
      int next = count;
      if (ranks.is_root())
        next = static_cast<int>(std::min<long>(counters_.add(SharedCounters::claimed, 1), count));
      MPI_Bcast(&next, 1, MPI_INT, 0, ranks.get());
      if (next == count) break;
      work_on(schedule_.side_by_side[next], ranks);
    }
    messages_.proceed(0);
    MPI_Request all_wait = MPI_REQUEST_NULL;
    MPI_Ibarrier(communicator_.get(), &all_wait);
    for (int are_done = 0; !are_done || messages_.is_receiving();) {
      MPI_Test(&all_wait, &are_done, MPI_STATUS_IGNORE);
      stop_if_asked();
      take_news();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }

  /// Works on the member, and passes the result on. Collective for the group.
  void work_on(int number, const Communicator& ranks) {
    long reported = 0;
    bool others_are_stopped = false;  // as rank 0 of the group knows
    double last = MPI_Wtime();
    const auto report = [&](long done) {
      counters_.add(SharedCounters::treated, done - reported);
      reported = done;
    };
    const auto take_progress = [&](double share) {
      constexpr double interval = 1;  // [s]
      if (MPI_Wtime() - last < interval) return;
      last = MPI_Wtime();
      report(std::lround(share * whole));
      others_are_stopped = is_stopped();
      take_news();
    };
    const RankGroup group{.ranks = ranks, .progress = take_progress, .is_to_stop = [&] {
                            return stop_if_asked() || others_are_stopped;
                          }};
    const StreamMember member = members_.member(number);
    MemberResult result;
    try {
      result = work_(member, group);
    } catch (const InputError& error) {
      result = failure_of(member, sinks_.program, error.what());
    } catch (const StoppedEarly&) {
      if (ranks.is_root()) counters_.add(SharedCounters::stopped, 1);
      return;
    }
    if (!ranks.is_root()) return;
    report(whole);
    if (results_)
      results_->add(to_bytes(number, result));
    else
      messages_.send(to_bytes(number, result));
    take_news();
  }

  /// Takes results of other groups and tells the progress, on rank 0.
  void take_news() {
    messages_.proceed();
    if (!results_) return;
    while (const std::string* bytes = messages_.next()) results_->add(*bytes);
    progress_.update(num_earlier_ + static_cast<double>(counters_.value(SharedCounters::treated)) / whole,
                     num_earlier_);
  }

  const StoredStream& members_;
  const StreamSchedule& schedule_;
  const Work& work_;
  const StreamSinks& sinks_;
  const Communicator& communicator_;
  SharedCounters counters_;
  ResultMessages messages_;
  StreamProgress progress_;
  std::optional<ResultsInOrder> results_;  ///< on rank 0
  int num_earlier_ = 0;
  bool has_stopped_ = false;  ///< true: this rank has stopped all groups
};

}  // namespace

StreamTally work_on_ranks(const StoredStream& members, StreamSchedule schedule,
                          const std::function<MemberResult(const StreamMember&, const RankGroup&)>& work,
                          const StreamSinks& sinks, const Communicator& communicator) {
  const std::vector<char> has_earlier = remove_earlier(schedule, members.size(), sinks, communicator);
  return StreamOnRanks(members, schedule, work, sinks, communicator).run(has_earlier);
}

}  // namespace beadswim
