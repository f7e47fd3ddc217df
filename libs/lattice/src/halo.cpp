#include "beadswim/lattice/halo.hpp"

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

/// Calls visit(cell) for local coordinates in [low, high), x fastest.
template <class Visit>
void for_each_cell_between(const Populations& populations, const Index3& low, const Index3& high,
                           Visit&& visit) {
  for (int z = low[2]; z < high[2]; ++z) {
    for (int y = low[1]; y < high[1]; ++y) {
      for (int x = low[0]; x < high[0]; ++x) visit(populations.cell(x, y, z));
    }
  }
}

/// Calls visit(cell) for a plane of cells across `axis` at local coordinate `at`: own cells along later axes,
/// halo included along axes already filled.
template <class Visit>
void for_each_cell_of_plane(const Populations& populations, int axis, int at, Visit&& visit) {
  Index3 low, high;
  for (int a = 0; a < 3; ++a) {
    const int halo = a < axis ? 1 : 0;
    low[a] = a == axis ? at : -halo;
    high[a] = a == axis ? at + 1 : populations.size()[a] + halo;
  }
  for_each_cell_between(populations, low, high, visit);
}

int halo_plane(const Populations& p, int axis, int side) {
  return side == 0 ? -1 : p.size()[axis];
}
int edge_plane(const Populations& p, int axis, int side) {
  return side == 0 ? 0 : p.size()[axis] - 1;
}

/// Mirror: what enters along i left along its mirror image, from the cell in front of the wall.
void fill_free_slip(Populations& populations, int axis, int side) {
  const std::ptrdiff_t inward = entering_sign(side) * populations.pitch(axis);
  for (const int i : directions_along(axis, entering_sign(side))) {
    const int image = d3q19::mirrored(i, axis);
    for_each_cell_of_plane(populations, axis, halo_plane(populations, axis, side), [&](std::ptrdiff_t cell) {
      populations.outgoing(i, cell) = populations.outgoing(image, cell + inward);
    });
  }
}

/// Bounce-back: what enters an own cell along i left the same cell along the opposite direction. Local, and
/// so needs no halo; it overrules what other axes put where two walls meet.
void bounce_back_at_face(Populations& populations, int axis, int side) {
  Index3 low = Index3::Zero(), high = populations.size();
  low[axis] = edge_plane(populations, axis, side);
  high[axis] = low[axis] + 1;
  for (const int i : directions_along(axis, entering_sign(side))) {
    for_each_cell_between(populations, low, high, [&](std::ptrdiff_t cell) {
      populations.incoming(i, cell) = populations.outgoing(d3q19::opposite(i), cell);
    });
  }
}

/// What leaves through the face on `side`, in the order in which unpack() reads it on the other side.
void pack(const Populations& populations, int axis, int side, std::vector<double>& buffer) {
  buffer.clear();
  for (const int i : directions_along(axis, -entering_sign(side))) {
    for_each_cell_of_plane(populations, axis, edge_plane(populations, axis, side),
                           [&](std::ptrdiff_t cell) { buffer.push_back(populations.outgoing(i, cell)); });
  }
}

void unpack(Populations& populations, int axis, int side, const std::vector<double>& buffer) {
  auto value = buffer.begin();
  for (const int i : directions_along(axis, entering_sign(side))) {
    for_each_cell_of_plane(populations, axis, halo_plane(populations, axis, side),
                           [&](std::ptrdiff_t cell) { populations.outgoing(i, cell) = *value++; });
  }
}

}  // namespace

Halo::Halo(const Communicator& communicator, const Decomposition& decomposition,
           const std::array<Wall, 3>& walls)
    : comm_(communicator.get()), rank_(communicator.rank()) {
  const Index3 position = decomposition.grid_position(rank_);
  for (int axis = 0; axis < 3; ++axis) {
    const int blocks = decomposition.grid()[axis];
    for (int side = 0; side < 2; ++side) {
      Index3 neighbour = position;
      neighbour[axis] += side == 0 ? -1 : 1;
      const bool outside = neighbour[axis] < 0 || neighbour[axis] >= blocks;
      neighbour[axis] = (neighbour[axis] + blocks) % blocks;
      Face& face = faces_[axis][side];
      face.closed_by = outside ? walls[axis] : Wall::periodic;
      face.neighbour = face.is_open() ? decomposition.rank_at(neighbour) : MPI_PROC_NULL;
    }
  }
}

void Halo::fill(Populations& populations) {
  for (int axis = 0; axis < 3; ++axis) {
    fill_from_neighbours(populations, axis);
    for (int side = 0; side < 2; ++side) {
      if (at_wall(axis, side, Wall::free_slip)) fill_free_slip(populations, axis, side);
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      if (at_wall(axis, side, Wall::no_slip)) bounce_back_at_face(populations, axis, side);
    }
  }
}

void Halo::fill_from_neighbours(Populations& populations, int axis) {
  auto& [low, high] = faces_[axis];
  for (int side = 0; side < 2; ++side) {
    if (faces_[axis][side].is_open()) pack(populations, axis, side, faces_[axis][side].send);
  }
  if (low.neighbour == rank_) {  // an axis that is not cut: the block is its own neighbour on both sides
    unpack(populations, axis, 0, high.send);
    unpack(populations, axis, 1, low.send);
    return;
  }
  std::array<MPI_Request, 4> requests;
  int count = 0;
  for (int side = 0; side < 2; ++side) {
    Face& face = faces_[axis][side];
    face.receive.resize(face.send.size());
    const int size = static_cast<int>(face.send.size());
    // A message is tagged by the side through which it leaves; two blocks may meet at both their faces.
    MPI_Irecv(face.receive.data(), size, MPI_DOUBLE, face.neighbour, 1 - side, comm_, &requests[count++]);
    MPI_Isend(face.send.data(), size, MPI_DOUBLE, face.neighbour, side, comm_, &requests[count++]);
  }
  MPI_Waitall(count, requests.data(), MPI_STATUSES_IGNORE);
  for (int side = 0; side < 2; ++side) {
    if (faces_[axis][side].is_open()) unpack(populations, axis, side, faces_[axis][side].receive);
  }
}

}  // namespace beadswim
