#include "beadswim/lattice/halo.hpp"

#include <algorithm>

#include "beadswim/lattice/lattice_vector.hpp"

namespace beadswim {
namespace {

constexpr int entering_directions = 5;
using FaceDirections = std::array<int, entering_directions>;

/// Returns the directions whose velocity component `axis` equals `sign`.
constexpr FaceDirections directions_along(int axis, int sign) {
  FaceDirections found{};
  int count = 0;
  for (int i = 0; i < d3q19::directions; ++i) {
    if (d3q19::velocity[i][axis] == sign) found[count++] = i;
  }
  return found;
}

/// Returns the sign of the velocity of populations that enter the block through the face on `side` of an axis
/// (0: low side, 1: high side).
constexpr int entering_sign(int side) {
  return side == 0 ? 1 : -1;
}

int halo_plane(const Populations& p, int axis, int side) {
  return side == 0 ? -1 : p.size()[axis];
}
int edge_plane(const Populations& p, int axis, int side) {
  return side == 0 ? 0 : p.size()[axis] - 1;
}

/// Consecutive cells along x, which are contiguous in memory.
struct CellRun {
  std::ptrdiff_t first;
  int cells;
  std::ptrdiff_t next;  ///< index of the first cell of the next run minus `first`
};

/// Prefetches the populations of a run of cells, because runs are too short for the hardware prefetcher.
template <class Real>
void prefetch_run(const Real* first, const CellRun& run) {
  constexpr int line = 64 / sizeof(Real);
  for (int x = 0; x < run.cells; x += line) __builtin_prefetch(first + x, 1);
}

/// Copies the populations of a run of cells. Returns the address after the last copied value.
template <class Real>
Real* copy_run(const Real* from, const CellRun& run, Real* to) {
  if (run.cells == 1) {  // planes perpendicular to x: avoids a function call
    *to = *from;
    return to + 1;
  }
  return std::copy_n(from, run.cells, to);
}

/// Calls visit(run) for every run of consecutive cells in the plane perpendicular to `axis` at the local
/// coordinate `at`. The plane includes the halo cells along the axes before `axis`, which are already filled,
/// but no halo cells along the axes after it. In a plane perpendicular to x, each run is a single cell.
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
      visit(CellRun{.first = populations.cell(low[0], y, z),
                    .cells = high[0] - low[0],
                    .next = populations.pitch(axis == 1 ? 2 : 1)});
    }
  }
}

/// Kind of a population of a cell. i is a direction that enters the block; ibar is the opposite direction.
enum class PopulationKind {
  entering,  ///< outgoing population i
  leaving,   ///< outgoing population ibar
  behind,    ///< incoming population i
};

/// Returns the address of the population of this kind and direction i in cell `first`. The same population of
/// the next cell along x follows in memory.
template <class Real, class SomePopulations>
auto* row_of(SomePopulations& populations, PopulationKind kind, int i, std::ptrdiff_t first) {
  if (kind == PopulationKind::behind)
    return populations.template outgoing_row<Real>(i, first - populations.shift(i));
  return populations.template outgoing_row<Real>(kind == PopulationKind::leaving ? d3q19::opposite(i) : i,
                                                 first);
}

/// Fills the halo plane on `side` of `axis`. For all k, copies the population of direction from[k] to the
/// population of direction to[k] of each halo cell. The source cell has an index that is larger than the
/// index of the halo cell by `distance`.
template <class Real>
void copy_into_halo(Populations& populations, PopulationKind kind, int axis, int side,
                    const FaceDirections& to, const FaceDirections& from, std::ptrdiff_t distance) {
  for_each_run_of_plane(populations, axis, halo_plane(populations, axis, side), [&](const CellRun& run) {
    for (int k = 0; k < entering_directions; ++k) {
      const Real* source = row_of<Real>(populations, kind, from[k], run.first + distance);
      Real* target = row_of<Real>(populations, kind, to[k], run.first);
      prefetch_run(source + run.next, run);
      prefetch_run(target + run.next, run);
      copy_run(source, run, target);
    }
  });
}

/// Fills the halo along a periodic axis that is not divided among ranks: populations that leave on one side
/// enter on the other side.
template <class Real>
void wrap_around(Populations& populations, PopulationKind kind, int axis) {
  const std::ptrdiff_t period = populations.size()[axis] * populations.pitch(axis);
  for (int side = 0; side < 2; ++side) {
    const FaceDirections entering = directions_along(axis, entering_sign(side));
    copy_into_halo<Real>(populations, kind, axis, side, entering, entering, entering_sign(side) * period);
  }
}

/// Mirrors populations at a free-slip wall: the population that enters along i left the cell in front of the
/// wall along the mirror image of i.
template <class Real>
void fill_free_slip(Populations& populations, PopulationKind kind, int axis, int side) {
  const FaceDirections entering = directions_along(axis, entering_sign(side));
  FaceDirections images;
  for (int k = 0; k < entering_directions; ++k) images[k] = d3q19::mirrored(entering[k], axis);
  copy_into_halo<Real>(populations, kind, axis, side, entering, images,
                       entering_sign(side) * populations.pitch(axis));
}

/// Bounces populations back at a no-slip wall, in the planes low_z <= z < high_z: the population that enters
/// a cell along i left the same cell along the opposite direction ibar. The halo is not read. At the edge
/// between two walls, bounce-back overwrites the populations that other axes have set. A wall with velocity u
/// adds momentum to the population:
///
///   f_i = f*_ibar + 6 w_i c_i.u
///
/// Ladd, J. Fluid Mech. 271 (1994) 285, with density 1 at the wall.
template <class Real>
void bounce_back_at_face(Populations& populations, int axis, int side, const Vec3& wall_velocity, int low_z,
                         int high_z) {
  Index3 low(0, 0, low_z), high(populations.size()[0], populations.size()[1], high_z);
  low[axis] = std::max(low[axis], edge_plane(populations, axis, side));
  high[axis] = std::min(high[axis], edge_plane(populations, axis, side) + 1);
  for (int z = low[2]; z < high[2]; ++z) {
    for (int y = low[1]; y < high[1]; ++y) {
      for (const int i : directions_along(axis, entering_sign(side))) {
        const CellRun run{.first = populations.cell(low[0], y, z), .cells = high[0] - low[0], .next = 0};
        const Real* from = populations.outgoing_row<Real>(d3q19::opposite(i), run.first);
        Real* to = populations.incoming_row<Real>(i, run.first);
        const auto added = static_cast<Real>(6 * d3q19::weight(i) * velocity_of(i).dot(wall_velocity));
        if (added == 0)
          copy_run(from, run, to);
        else
          std::transform(from, from + run.cells, to, [&](Real leaving) { return leaving + added; });
      }
    }
  }
}

/// Returns the number of populations of one kind that one message along `axis` contains.
std::size_t num_face_populations(const Populations& populations, int axis) {
  std::size_t count = entering_directions;
  for (int a = 0; a < 3; ++a) {
    if (a != axis) count *= populations.size()[a] + (a < axis ? 2 : 0);
  }
  return count;
}

/// Appends to `buffer` the populations that the neighbour across the face needs for its halo, in the order in
/// which unpack() reads them.
template <class Real>
void pack(const Populations& populations, PopulationKind kind, int axis, int side,
          std::vector<std::byte>& buffer) {
  const std::size_t first = buffer.size();
  buffer.resize(first + num_face_populations(populations, axis) * sizeof(Real));
  auto* to = reinterpret_cast<Real*>(buffer.data() + first);
  for_each_run_of_plane(populations, axis, edge_plane(populations, axis, side), [&](const CellRun& run) {
    for (const int i : directions_along(axis, -entering_sign(side))) {
      to = copy_run(row_of<Real>(populations, kind, i, run.first), run, to);
    }
  });
}

/// Fills the halo at a face from `buffer`. Returns the address of the first byte that it has not read.
template <class Real>
const std::byte* unpack(Populations& populations, PopulationKind kind, int axis, int side,
                        const std::byte* buffer) {
  const auto* from = reinterpret_cast<const Real*>(buffer);
  for_each_run_of_plane(populations, axis, halo_plane(populations, axis, side), [&](const CellRun& run) {
    for (const int i : directions_along(axis, entering_sign(side))) {
      copy_run(from, run, row_of<Real>(populations, kind, i, run.first));
      from += run.cells;
    }
  });
  return reinterpret_cast<const std::byte*>(from);
}

/// Calls visit(kind) for each kind of population that one message contains. A population of kind `behind` may
/// have entered the neighbour through another face. Messages with the kinds `leaving` and `behind` are
/// therefore exchanged after the messages with entering populations.
template <class Visit>
void for_each_kind(HaloContent content, Visit&& visit) {
  if (content == HaloContent::entering) return visit(PopulationKind::entering);
  visit(PopulationKind::leaving);
  visit(PopulationKind::behind);
}

}  // namespace

Halo::Halo(const Communicator& communicator, const Decomposition& decomposition,
           const std::array<Boundary, 3>& boundary, HaloContent content,
           const std::array<bool, 3>& at_interface)
    : comm_(communicator.get()), rank_(communicator.rank()), content_(content) {
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
      face.at_interface = outside && at_interface[axis];
      face.neighbour = face.is_open() ? decomposition.rank_at(neighbour) : MPI_PROC_NULL;
    }
  }
}

/// Does not free the message buffers if messages are in transit, because MPI may still write into them. This
/// happens only if an exception has interrupted a time step; the program is then about to stop all ranks.
Halo::~Halo() {
  if (!has_pending_messages_) return;
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
  if (has_pending_messages_) MPI_Testall(messages_.size(), messages_.data(), &done, MPI_STATUSES_IGNORE);
}

void Halo::finish(Populations& populations) {
  if (!has_pending_messages_) return;
  in_precision(populations.precision(), [&]<class Real>() {
    receive<Real>(populations, HaloContent::entering, 2);
    const int planes = populations.size()[2];
    for (const int z : {0, planes - 1}) bounce_back_at_walls<Real>(populations, z, z + 1);
  });
  has_pending_messages_ = false;
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
    has_pending_messages_ = axis == 2 && is_cut(2);
    if (is_cut(axis) && (axis < 2 || content_ == HaloContent::behind)) {
      receive<Real>(populations, HaloContent::entering, axis);
      has_pending_messages_ = false;
    }
  }
  const int first_axis = row_ends() == RowEnds::wrapped ? 1 : 0;
  for (int axis = first_axis; axis < 3 && content_ == HaloContent::behind; ++axis) {
    start_across<Real>(populations, HaloContent::behind, axis);
    if (is_cut(axis)) receive<Real>(populations, HaloContent::behind, axis);
  }
  bounce_back_at_walls<Real>(populations, 0, populations.size()[2]);
}

/// Fills the halo cells beyond the faces perpendicular to `axis` that need no message. Sends the messages
/// along this axis.
template <class Real>
void Halo::start_across(Populations& populations, HaloContent content, int axis) {
  if (is_cut(axis)) send<Real>(populations, content, axis);
  for_each_kind(content, [&](PopulationKind kind) {
    if (faces_[axis][0].neighbour == rank_) wrap_around<Real>(populations, kind, axis);
    for (int side = 0; side < 2; ++side) {
      if (at_wall(axis, side, Boundary::free_slip)) fill_free_slip<Real>(populations, kind, axis, side);
    }
  });
}

template <class Real>
void Halo::bounce_back_at_walls(Populations& populations, int low_z, int high_z) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      if (at_wall(axis, side, Boundary::no_slip))
        bounce_back_at_face<Real>(populations, axis, side, faces_[axis][side].wall_velocity, low_z, high_z);
    }
  }
}

template <class Real>
void Halo::send(const Populations& populations, HaloContent content, int axis) {
  for (int side = 0; side < 2; ++side) {
    Face& face = faces_[axis][side];
    if (!face.is_open()) continue;
    face.send.clear();
    for_each_kind(content,
                  [&](PopulationKind kind) { pack<Real>(populations, kind, axis, side, face.send); });
  }
  for (int side = 0; side < 2; ++side) {
    Face& face = faces_[axis][side];
    face.receive.resize(face.send.size());
    const int size = static_cast<int>(face.send.size());
    // The tag is the side through which a message leaves, because two blocks may be neighbours on both sides.
    MPI_Irecv(face.receive.data(), size, MPI_BYTE, face.neighbour, 1 - side, comm_, &messages_[2 * side]);
    MPI_Isend(face.send.data(), size, MPI_BYTE, face.neighbour, side, comm_, &messages_[2 * side + 1]);
    if (face.is_open()) traffic_.add_message(size);
  }
}

template <class Real>
void Halo::receive(Populations& populations, HaloContent content, int axis) {
  MPI_Waitall(messages_.size(), messages_.data(), MPI_STATUSES_IGNORE);
  for (int side = 0; side < 2; ++side) {
    if (!faces_[axis][side].is_open()) continue;
    const std::byte* from = faces_[axis][side].receive.data();
    for_each_kind(content,
                  [&](PopulationKind kind) { from = unpack<Real>(populations, kind, axis, side, from); });
  }
}

}  // namespace beadswim
