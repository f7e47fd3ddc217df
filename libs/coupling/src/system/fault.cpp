#include "beadswim/coupling/fault.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "beadswim/core/message.hpp"

namespace beadswim {

std::optional<Fault> first_fault(const std::optional<Fault>& own, const Communicator& communicator) {
  constexpr long never = std::numeric_limits<long>::max();
  long step = own ? own->step : never;
  MPI_Allreduce(MPI_IN_PLACE, &step, 1, MPI_LONG, MPI_MIN, communicator.get());
  if (step == never) return std::nullopt;

  Fault fault = own.value_or(Fault{});
  if (!own) fault.step = never;
  OutgoingMessage message;
  message(fault);
  const int bytes = static_cast<int>(message.bytes().size());
  std::vector<char> all(static_cast<std::size_t>(bytes) * communicator.size());
  MPI_Allgather(message.bytes().data(), bytes, MPI_BYTE, all.data(), bytes, MPI_BYTE, communicator.get());
  return std::ranges::min(values_from_bytes<Fault>(std::move(all)), comes_before);
}

}  // namespace beadswim
