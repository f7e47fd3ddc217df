#include "beadswim/lattice/halo.hpp"

#include <algorithm>
#include <span>

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

/// Fills the halo plane on `side` of `axis` with populations of the block itself: with those that leave on
/// the other side of a periodic axis that is not divided among ranks, or with mirror images at a free-slip
/// wall. There the population that enters along i left the cell in front of the wall along the mirror image
/// of i.
void fill_from_block(Populations& populations, PopulationKind kind, int axis, int side, Boundary boundary) {
  const FaceDirections entering = directions_along(axis, entering_sign(side));
  FaceDirections sources = entering;
  const bool mirrors = boundary == Boundary::free_slip;
  for (int& i : sources) i = mirrors ? d3q19::mirrored(i, axis) : i;
  // index of the source cell minus index of the halo cell
  const std::ptrdiff_t distance =
      entering_sign(side) * populations.pitch(axis) * (mirrors ? 1 : populations.size()[axis]);
  in_precision(populations.precision(), [&]<class Real>() {
    for_each_run_of_plane(populations, axis, halo_plane(populations, axis, side), [&](const CellRun& run) {
      for (int k = 0; k < entering_directions; ++k) {
        const Real* source = row_of<Real>(populations, kind, sources[k], run.first + distance);
        Real* target = row_of<Real>(populations, kind, entering[k], run.first);
        // Prefetches the next run, because runs are too short for the hardware prefetcher.
        for (int x = 0; x < run.cells; x += 64 / static_cast<int>(sizeof(Real))) {
          __builtin_prefetch(source + run.next + x, 1);
          __builtin_prefetch(target + run.next + x, 1);
        }
        copy_run(source, run, target);
      }
    });
  });
}

/// Bounces populations back at a no-slip wall, in the planes low_z <= z < high_z: the population that enters
/// a cell along i left the same cell along the opposite direction ibar. The halo is not read. At the edge
/// between two walls, bounce-back overwrites the populations that other axes have set. A wall with velocity u
/// adds momentum to the population:
///
///   f_i = f*_ibar + 6 w_i c_i.u
///
/// Ladd, J. Fluid Mech. 271 (1994) 285, with density 1 at the wall.
void bounce_back_at_face(Populations& populations, int axis, int side, const Vec3& wall_velocity, int low_z,
                         int high_z) {
  Index3 low(0, 0, low_z), high(populations.size()[0], populations.size()[1], high_z);
  low[axis] = std::max(low[axis], edge_plane(populations, axis, side));
  high[axis] = std::min(high[axis], edge_plane(populations, axis, side) + 1);
  in_precision(populations.precision(), [&]<class Real>() {
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
  });
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
void pack(const Populations& populations, PopulationKind kind, int axis, int side,
          std::vector<std::byte>& buffer) {
  in_precision(populations.precision(), [&]<class Real>() {
    const std::size_t first = buffer.size();
    buffer.resize(first + num_face_populations(populations, axis) * sizeof(Real));
    auto* to = reinterpret_cast<Real*>(buffer.data() + first);
    for_each_run_of_plane(populations, axis, edge_plane(populations, axis, side), [&](const CellRun& run) {
      for (const int i : directions_along(axis, -entering_sign(side)))
        to = copy_run(row_of<Real>(populations, kind, i, run.first), run, to);
    });
  });
}

/// Fills the halo at a face from `buffer`. Returns the address of the first byte that it has not read.
const std::byte* unpack(Populations& populations, PopulationKind kind, int axis, int side,
                        const std::byte* buffer) {
  return in_precision(populations.precision(), [&]<class Real>() {
    const auto* from = reinterpret_cast<const Real*>(buffer);
    for_each_run_of_plane(populations, axis, halo_plane(populations, axis, side), [&](const CellRun& run) {
      for (const int i : directions_along(axis, entering_sign(side))) {
        copy_run(from, run, row_of<Real>(populations, kind, i, run.first));
        from += run.cells;
      }
    });
    return reinterpret_cast<const std::byte*>(from);
  });
}

/// Returns the kinds of populations that one message contains. A population of kind `behind` may have entered
/// the neighbour through another face. Messages with the kinds `leaving` and `behind` are therefore exchanged
/// after the messages with entering populations.
std::span<const PopulationKind> kinds_of(HaloContent content) {
  static constexpr std::array all{PopulationKind::entering, PopulationKind::leaving, PopulationKind::behind};
  return content == HaloContent::entering ? std::span(all).first(1) : std::span(all).last(2);
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
  receive(populations, HaloContent::entering, 2);
  for (const int z : {0, populations.size()[2] - 1}) bounce_back_at_walls(populations, z, z + 1);
  has_pending_messages_ = false;
}

RowEnds Halo::row_ends() const {
  if (at_wall(0, 0, Boundary::free_slip) && at_wall(0, 1, Boundary::free_slip)) return RowEnds::mirrored;
  return faces_[0][0].neighbour == rank_ ? RowEnds::wrapped : RowEnds::left_to_halo;
}

void Halo::start(Populations& populations) {
  const bool x_is_filled = row_ends() != RowEnds::left_to_halo && populations.row_ends_filled() == row_ends();
  for (int axis = x_is_filled ? 1 : 0; axis < 3; ++axis) {
    start_across(populations, HaloContent::entering, axis);
    has_pending_messages_ = axis == 2 && is_cut(2);
    if (is_cut(axis) && (axis < 2 || content_ == HaloContent::behind)) {
      receive(populations, HaloContent::entering, axis);
      has_pending_messages_ = false;
    }
  }
  const int first_axis = row_ends() == RowEnds::wrapped ? 1 : 0;
  for (int axis = first_axis; axis < 3 && content_ == HaloContent::behind; ++axis) {
    start_across(populations, HaloContent::behind, axis);
    if (is_cut(axis)) receive(populations, HaloContent::behind, axis);
  }
  bounce_back_at_walls(populations, 0, populations.size()[2]);
}

/// Fills the halo cells beyond the faces perpendicular to `axis` that need no message. Sends the messages
/// along this axis.
void Halo::start_across(Populations& populations, HaloContent content, int axis) {
  if (is_cut(axis)) send(populations, content, axis);
  for (const PopulationKind kind : kinds_of(content)) {
    for (int side = 0; side < 2; ++side) {
      if (faces_[axis][0].neighbour == rank_ || at_wall(axis, side, Boundary::free_slip))
        fill_from_block(populations, kind, axis, side, faces_[axis][side].closed_by);
    }
  }
}

void Halo::bounce_back_at_walls(Populations& populations, int low_z, int high_z) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      if (at_wall(axis, side, Boundary::no_slip))
        bounce_back_at_face(populations, axis, side, faces_[axis][side].wall_velocity, low_z, high_z);
    }
  }
}

void Halo::send(const Populations& populations, HaloContent content, int axis) {
  for (int side = 0; side < 2; ++side) {
    Face& face = faces_[axis][side];
    if (!face.is_open()) continue;
    face.send.clear();
    for (const PopulationKind kind : kinds_of(content)) pack(populations, kind, axis, side, face.send);
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

void Halo::receive(Populations& populations, HaloContent content, int axis) {
  MPI_Waitall(messages_.size(), messages_.data(), MPI_STATUSES_IGNORE);
  for (int side = 0; side < 2; ++side) {
    if (!faces_[axis][side].is_open()) continue;
    const std::byte* from = faces_[axis][side].receive.data();
    for (const PopulationKind kind : kinds_of(content)) from = unpack(populations, kind, axis, side, from);
  }
}

}  // namespace beadswim
