#include "beadswim/lattice/halo.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"

namespace beadswim {
namespace {

constexpr int entering_directions = 5;
using FaceDirections = std::array<int, entering_directions>;

/// Directions with c_axis = sign.
constexpr FaceDirections directions_along(int axis, int sign) {
  FaceDirections found{};
  int count = 0;
  for (int i = 0; i < d3q19::directions; ++i) {
    if (d3q19::velocity[i][axis] == sign) found[count++] = i;
  }
  return found;
}

/// Velocity component with which populations enter through a face.
constexpr int entering_sign(int side) {
  return side == 0 ? 1 : -1;
}

int halo_plane(const Populations& p, int axis, int side) {
  return side == 0 ? -1 : p.size()[axis];
}
int edge_plane(const Populations& p, int axis, int side) {
  return side == 0 ? 0 : p.size()[axis] - 1;
}

/// A run of cells along x, one after the other in memory.
struct Run {
  std::ptrdiff_t first;
  int cells;
  std::ptrdiff_t next;  ///< from here to the run after it, as far as there is one
};

/// Asks for the memory of as many numbers: runs are too short for the processor to see them coming.
template <class Real>
void prefetch_run(const Real* first, const Run& run) {
  constexpr int line = 64 / sizeof(Real);
  for (int x = 0; x < run.cells; x += line) __builtin_prefetch(first + x, 1);
}

/// Copies a run's numbers; returns where the target ends.
template <class Real>
Real* copy_run(const Real* from, const Run& run, Real* to) {
  if (run.cells == 1) {  // most of all runs, those across x: not worth a call
    *to = *from;
    return to + 1;
  }
  return std::copy_n(from, run.cells, to);
}

/// The plane of cells across `axis` at local coordinate `at` as runs: own cells along later axes, halo
/// included along axes already filled. Across x a run is a single cell.
template <class Visit>
void for_each_run_of_plane(const Populations& populations, int axis, int at, Visit&& visit) {
  Index3 low, high;
  for (int a = 0; a < 3; ++a) {
    const int halo = a < axis ? 1 : 0;
    low[a] = a == axis ? at : -halo;
    high[a] = a == axis ? at + 1 : populations.size()[a] + halo;
  }
  for (int z = low[2]; z < high[2]; ++z) {
    for (int y = low[1]; y < high[1]; ++y) {
      visit(Run{populations.cell(low[0], y, z), high[0] - low[0], populations.pitch(axis == 1 ? 2 : 1)});
    }
  }
}

/// Numbers of a cell, for a direction i that enters the block.
enum class Numbers {
  entering,  ///< outgoing i
  leaving,   ///< outgoing ibar
  behind,    ///< incoming i
};

/// Those of cells along a row.
template <class Real, class SomePopulations>
auto* row_of(SomePopulations& populations, Numbers numbers, int i, std::ptrdiff_t first) {
  if (numbers == Numbers::behind)
    return populations.template outgoing_row<Real>(i, first - populations.shift(i));
  return populations.template outgoing_row<Real>(numbers == Numbers::leaving ? d3q19::opposite(i) : i, first);
}

/// What is sent through the halo plane on `side` of `axis`, for every cell of the plane: numbers `to` of the
/// halo cell become numbers `from` of the cell that is `distance` on in memory.
template <class Real>
void copy_into_halo(Populations& populations, Numbers numbers, int axis, int side, const FaceDirections& to,
                    const FaceDirections& from, std::ptrdiff_t distance) {
  for_each_run_of_plane(populations, axis, halo_plane(populations, axis, side), [&](const Run& run) {
    for (int k = 0; k < entering_directions; ++k) {
      const Real* source = row_of<Real>(populations, numbers, from[k], run.first + distance);
      Real* target = row_of<Real>(populations, numbers, to[k], run.first);
      prefetch_run(source + run.next, run);
      prefetch_run(target + run.next, run);
      copy_run(source, run, target);
    }
  });
}

/// A periodic axis that is not cut: what enters on one side leaves on the other.
template <class Real>
void wrap_around(Populations& populations, Numbers numbers, int axis) {
  const std::ptrdiff_t period = populations.size()[axis] * populations.pitch(axis);
  for (int side = 0; side < 2; ++side) {
    const FaceDirections entering = directions_along(axis, entering_sign(side));
    copy_into_halo<Real>(populations, numbers, axis, side, entering, entering, entering_sign(side) * period);
  }
}

/// Mirror: what enters along i left along its mirror image, from the cell in front of the wall.
template <class Real>
void fill_free_slip(Populations& populations, Numbers numbers, int axis, int side) {
  const FaceDirections entering = directions_along(axis, entering_sign(side));
  FaceDirections images;
  for (int k = 0; k < entering_directions; ++k) images[k] = d3q19::mirrored(entering[k], axis);
  copy_into_halo<Real>(populations, numbers, axis, side, entering, images,
                       entering_sign(side) * populations.pitch(axis));
}

/// Bounce-back: what enters an own cell along i left the same cell along the opposite direction. Local, and
/// so needs no halo; it overrules what other axes put where two walls meet. In planes [low_z,
/// high_z).
template <class Real>
void bounce_back_at_face(Populations& populations, int axis, int side, int low_z, int high_z) {
  Index3 low(0, 0, low_z), high(populations.size()[0], populations.size()[1], high_z);
  low[axis] = std::max(low[axis], edge_plane(populations, axis, side));
  high[axis] = std::min(high[axis], edge_plane(populations, axis, side) + 1);
  for (int z = low[2]; z < high[2]; ++z) {
    for (int y = low[1]; y < high[1]; ++y) {
      for (const int i : directions_along(axis, entering_sign(side))) {
        const Run run{populations.cell(low[0], y, z), high[0] - low[0], 0};
        copy_run(populations.outgoing_row<Real>(d3q19::opposite(i), run.first), run,
                 populations.incoming_row<Real>(i, run.first));
      }
    }
  }
}

/// Numbers of one kind that leave through a face.
std::size_t face_numbers(const Populations& populations, int axis) {
  std::size_t numbers = entering_directions;
  for (int a = 0; a < 3; ++a) {
    if (a != axis) numbers *= populations.size()[a] + (a < axis ? 2 : 0);
  }
  return numbers;
}

/// What the halo on the other side of the face on `side` needs, appended to `buffer` in the order in which
/// unpack() reads it there.
template <class Real>
void pack(const Populations& populations, Numbers numbers, int axis, int side,
          std::vector<std::byte>& buffer) {
  const std::size_t first = buffer.size();
  buffer.resize(first + face_numbers(populations, axis) * sizeof(Real));
  auto* to = reinterpret_cast<Real*>(buffer.data() + first);
  for_each_run_of_plane(populations, axis, edge_plane(populations, axis, side), [&](const Run& run) {
    for (const int i : directions_along(axis, -entering_sign(side))) {
      to = copy_run(row_of<Real>(populations, numbers, i, run.first), run, to);
    }
  });
}

/// Returns where the numbers after those of this kind begin.
template <class Real>
const std::byte* unpack(Populations& populations, Numbers numbers, int axis, int side,
                        const std::byte* buffer) {
  const auto* from = reinterpret_cast<const Real*>(buffer);
  for_each_run_of_plane(populations, axis, halo_plane(populations, axis, side), [&](const Run& run) {
    for (const int i : directions_along(axis, entering_sign(side))) {
      copy_run(from, run, row_of<Real>(populations, numbers, i, run.first));
      from += run.cells;
    }
  });
  return reinterpret_cast<const std::byte*>(from);
}

/// Calls visit(numbers) for each kind that is filled together. What is behind a halo cell may itself have
/// come through another face, and so is filled after all that enters.
template <class Visit>
void for_each_kind(HaloContent together, Visit&& visit) {
  if (together == HaloContent::entering) return visit(Numbers::entering);
  visit(Numbers::leaving);
  visit(Numbers::behind);
}

}  // namespace

Halo::Halo(const Communicator& communicator, const Decomposition& decomposition,
           const std::array<Boundary, 3>& boundary, HaloContent content)
    : comm_(communicator.get()), rank_(communicator.rank()), content_(content) {
  if (content == HaloContent::behind && (decomposition.cells() < 2 * decomposition.grid()).any()) {
    throw InputError(fmt::format(
        "a block is a single cell thick on {} ranks, too thin for what multireflection reads; use "
        "fewer ranks, or another {}",
        communicator.size(), Setting::bead_boundary));
  }
  const Index3 position = decomposition.grid_position(rank_);
  for (int axis = 0; axis < 3; ++axis) {
    const int blocks = decomposition.grid()[axis];
    for (int side = 0; side < 2; ++side) {
      Index3 neighbour = position;
      neighbour[axis] += side == 0 ? -1 : 1;
      const bool outside = neighbour[axis] < 0 || neighbour[axis] >= blocks;
      neighbour[axis] = (neighbour[axis] + blocks) % blocks;
      Face& face = faces_[axis][side];
      face.closed_by = outside ? boundary[axis] : Boundary::periodic;
      face.neighbour = face.is_open() ? decomposition.rank_at(neighbour) : MPI_PROC_NULL;
    }
  }
}

/// Messages still under way: an error broke a step off, and the program is about to stop all ranks. MPI may
/// write into their buffers until then.
Halo::~Halo() {
  if (!is_under_way_) return;
  for (Face& face : faces_[2]) {
    static_cast<void>(new std::vector<std::byte>(std::move(face.send)));
    static_cast<void>(new std::vector<std::byte>(std::move(face.receive)));
  }
}

void Halo::start(Populations& populations) {
  in_precision(populations.precision(), [&]<class Real>() { start_as<Real>(populations); });
}

std::set<int> Halo::neighbours() const {
  std::set<int> others;
  for (const auto& sides : faces_) {
    for (const Face& face : sides) {
      if (face.is_open() && face.neighbour != rank_) others.insert(face.neighbour);
    }
  }
  return others;
}

void Halo::progress() {
  int done = 0;
  if (is_under_way_) MPI_Testall(messages_.size(), messages_.data(), &done, MPI_STATUSES_IGNORE);
}

void Halo::finish(Populations& populations) {
  if (!is_under_way_) return;
  in_precision(populations.precision(), [&]<class Real>() {
    receive<Real>(populations, HaloContent::entering, 2);
    const int planes = populations.size()[2];
    for (const int z : {0, planes - 1}) bounce_back_at_walls<Real>(populations, z, z + 1);
  });
  is_under_way_ = false;
}

RowEnds Halo::row_ends() const {
  if (at_wall(0, 0, Boundary::free_slip) && at_wall(0, 1, Boundary::free_slip)) return RowEnds::mirrored;
  return faces_[0][0].neighbour == rank_ ? RowEnds::wrapped : RowEnds::left_to_halo;
}

template <class Real>
void Halo::start_as(Populations& populations) {
  const bool x_is_filled = row_ends() != RowEnds::left_to_halo && populations.row_ends_filled() == row_ends();
  for (int axis = x_is_filled ? 1 : 0; axis < 3; ++axis) {
    start_across<Real>(populations, HaloContent::entering, axis);
    is_under_way_ = axis == 2 && is_cut(2);
    if (is_cut(axis) && (axis < 2 || content_ == HaloContent::behind)) {
      receive<Real>(populations, HaloContent::entering, axis);
      is_under_way_ = false;
    }
  }
  const int first_axis = row_ends() == RowEnds::wrapped ? 1 : 0;
  for (int axis = first_axis; axis < 3 && content_ == HaloContent::behind; ++axis) {
    start_across<Real>(populations, HaloContent::behind, axis);
    if (is_cut(axis)) receive<Real>(populations, HaloContent::behind, axis);
  }
  bounce_back_at_walls<Real>(populations, 0, populations.size()[2]);
}

/// Fills, across one axis, all of a kind that needs no message, and sends the messages.
template <class Real>
void Halo::start_across(Populations& populations, HaloContent together, int axis) {
  if (is_cut(axis)) send<Real>(populations, together, axis);
  for_each_kind(together, [&](Numbers numbers) {
    if (faces_[axis][0].neighbour == rank_) wrap_around<Real>(populations, numbers, axis);
    for (int side = 0; side < 2; ++side) {
      if (at_wall(axis, side, Boundary::free_slip)) fill_free_slip<Real>(populations, numbers, axis, side);
    }
  });
}

template <class Real>
void Halo::bounce_back_at_walls(Populations& populations, int low_z, int high_z) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      if (at_wall(axis, side, Boundary::no_slip))
        bounce_back_at_face<Real>(populations, axis, side, low_z, high_z);
    }
  }
}

template <class Real>
void Halo::send(const Populations& populations, HaloContent together, int axis) {
  for (int side = 0; side < 2; ++side) {
    Face& face = faces_[axis][side];
    if (!face.is_open()) continue;
    face.send.clear();
    for_each_kind(together,
                  [&](Numbers numbers) { pack<Real>(populations, numbers, axis, side, face.send); });
  }
  for (int side = 0; side < 2; ++side) {
    Face& face = faces_[axis][side];
    face.receive.resize(face.send.size());
    const int size = static_cast<int>(face.send.size());
    // A message is tagged by the side through which it leaves; two blocks may meet at both their faces.
    MPI_Irecv(face.receive.data(), size, MPI_BYTE, face.neighbour, 1 - side, comm_, &messages_[2 * side]);
    MPI_Isend(face.send.data(), size, MPI_BYTE, face.neighbour, side, comm_, &messages_[2 * side + 1]);
    if (face.is_open()) traffic_.add_message(size);
  }
}

template <class Real>
void Halo::receive(Populations& populations, HaloContent together, int axis) {
  MPI_Waitall(messages_.size(), messages_.data(), MPI_STATUSES_IGNORE);
  for (int side = 0; side < 2; ++side) {
    if (!faces_[axis][side].is_open()) continue;
    const std::byte* from = faces_[axis][side].receive.data();
    for_each_kind(together,
                  [&](Numbers numbers) { from = unpack<Real>(populations, numbers, axis, side, from); });
  }
}

}  // namespace beadswim
