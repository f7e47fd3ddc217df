#include "beadswim/coupling/bead_exchange.hpp"

#include <algorithm>
#include <limits>

namespace beadswim {
namespace {

/// Number of layers of cells around a block. A rank receives all beads that touch its block or these layers.
/// It therefore also receives a bead that has left its block in this step.
constexpr int margin = 2;

constexpr int publish_tag = 11, collect_tag = 12;  // Halo uses the tags 0 and 1

/// Returns, for each bead, the length of the shortest way along bonds at rest length from the bead in the
/// middle of the list [length].
std::vector<double> ways_from_middle(const SwimmerType& type) {
  std::vector<double> ways(type.beads.size(), std::numeric_limits<double>::infinity());
  ways[ways.size() / 2] = 0;
  for (std::size_t round = 0; round < ways.size(); ++round) {  // Bellman and Ford
    for (const Bond& bond : type.bonds) {
      double &one = ways[bond.beads[0]], &other = ways[bond.beads[1]];
      one = std::min(one, other + bond.rest_length);
      other = std::min(other, one + bond.rest_length);
    }
  }
  return ways;
}

/// Returns an upper bound of the distance from SwimmerState::middle() at which a bead of the same swimmer can
/// touch a cell [cell].
double max_touched_distance(const CoupledScene& scene) {
  double farthest = 0;
  for (const SwimmerType& type : scene.types) {
    const std::vector<double> ways = ways_from_middle(type);
    for (std::size_t b = 0; b < ways.size(); ++b)
      farthest = std::max(farthest, max_stretch * ways[b] + scene.radius_on_lattice(type.beads[b].radius));
  }
  return farthest + margin + 1;
}

/// Returns true if an image of the bead may cover a cell of the block or of the `margin` layers around it.
bool touches(const BlockInLattice& lattice_block, const BeadOnLattice& bead) {
  bool is_found = false;
  for_each_image(lattice_block, margin, bead.motion.position, bead.radius,
                 [&](const BeadImage&) { is_found = true; });
  return is_found;
}

/// Returns true if the distance of two blocks is at most `distance` along every axis [cell].
bool within(const BlockInLattice& a, const BlockInLattice& b, double distance) {
  const Vec3 centre = (b.block.offset.cast<double>() + 0.5 * b.block.size.cast<double>()).matrix();
  for (int axis = 0; axis < 3; ++axis) {
    const double half = 0.5 * (a.block.size[axis] + b.block.size[axis]) + distance;
    double gap = std::abs(a.block.offset[axis] + 0.5 * a.block.size[axis] - centre[axis]);
    if (a.is_periodic(axis)) gap = std::min(gap, a.cells[axis] - gap);
    if (gap > half) return false;
  }
  return true;
}

}  // namespace

BeadExchange::BeadExchange(const Communicator& communicator, const Decomposition& decomposition,
                           const CoupledScene& scene)
    : comm_(communicator.get()),
      rank_(communicator.rank()),
      decomposition_(decomposition),
      place_{.lattice = decomposition.lattice(), .box = scene.cells, .boundary = scene.boundary},
      types_(scene.types) {
  for (const SwimmerType& type : scene.types) {
    std::vector<double>& radii = radii_.emplace_back();
    for (const Bead& bead : type.beads) radii.push_back(scene.radius_on_lattice(bead.radius));
  }
  for (int r = 0; r < communicator.size(); ++r) {
    blocks_.push_back({.block = decomposition.block(r), .cells = scene.cells, .boundary = scene.boundary});
  }
  for (int r = 0; r < communicator.size(); ++r) {
    if (within(blocks_[rank_], blocks_[r], max_touched_distance(scene))) peers_.push_back(r);
  }
}

int BeadExchange::owner_of(const Vec3& position) const {
  const Block& lattice = place_.lattice;
  const Index3 cell = place_.in_lattice(position.array().floor().cast<int>());
  return decomposition_.rank_of_cell(cell.max(lattice.offset).min(lattice.end() - 1));
}

std::optional<Fault> BeadExchange::position_fault(const SwimmerState& swimmer) const {
  const auto position = [&](int b) { return swimmer.motion[b].position; };
  if (auto fault = torn_arm(types_[swimmer.type], swimmer.id, position)) return fault;
  for (int b = 0; b < std::ssize(swimmer.motion); ++b) {
    const Vec3& place = swimmer.motion[b].position;
    const auto gap_to = [&](int axis, int low, int high) {
      return std::min(place[axis] - low, high - place[axis]) - radii_[swimmer.type][b];
    };
    const auto fault = [&](FaultKind kind, double gap) {
      return Fault{.kind = kind, .bead = {swimmer.id, b}, .position = place, .value = gap};
    };
    for (int axis = 0; axis < 3; ++axis) {
      const double to_wall = gap_to(axis, 0, place_.box[axis]);
      if (place_.boundary[axis] != Boundary::periodic && !(to_wall >= min_wall_gap))
        return fault(FaultKind::wall, to_wall);
      const double to_level = gap_to(axis, place_.lattice.offset[axis], place_.lattice.end()[axis]);
      if (!place_.spans(axis) && !(to_level >= min_level_gap)) return fault(FaultKind::level, to_level);
    }
  }
  return std::nullopt;
}

std::vector<BeadOnLattice> BeadExchange::publish(std::vector<SwimmerState>& owned) {
  std::vector<SwimmerState> staying;
  std::vector<std::vector<const SwimmerState*>> departing(peers_.size());
  std::vector<OutgoingMessage> beads_nearby(peers_.size());
  for (const SwimmerState& swimmer : owned) {
    const int owner = owner_of(swimmer.middle());
    if (owner == rank_) staying.push_back(swimmer);
    for (std::size_t p = 0; p < peers_.size(); ++p)
      if (peers_[p] == owner && owner != rank_) departing[p].push_back(&swimmer);
    for (int b = 0; b < std::ssize(swimmer.motion); ++b) {
      const BeadOnLattice bead{.name = {swimmer.id, b},
                               .owner = owner,
                               .radius = radii_[swimmer.type][b],
                               .motion = swimmer.motion[b],
                               .body = types_[swimmer.type].beads[b],
                               .predicted = swimmer.predicted[b],
                               .removed_fraction = swimmer.removed_fraction[b],
                               .mass_source = swimmer.mass_source[b],
                               .impulse = {}};
      for (std::size_t p = 0; p < peers_.size(); ++p)
        if (touches(blocks_[peers_[p]], bead)) beads_nearby[p](bead);
    }
  }
  std::vector<OutgoingMessage> to_peers(peers_.size());
  for (std::size_t p = 0; p < peers_.size(); ++p) {
    to_peers[p](static_cast<int>(departing[p].size()));
    for (const SwimmerState* swimmer : departing[p]) to_peers[p](*swimmer);
    to_peers[p].append(beads_nearby[p]);
  }
  owned = std::move(staying);

  std::vector<BeadOnLattice> beads;
  for (IncomingMessage& message : exchange(to_peers, publish_tag)) {
    int arrivals = 0;
    message(arrivals);
    while (arrivals-- > 0) message(owned.emplace_back());
    while (!message.is_at_end()) message(beads.emplace_back());
  }
  std::ranges::sort(owned, {}, &SwimmerState::id);
  std::ranges::sort(beads, {}, &BeadOnLattice::name);
  return beads;
}

std::map<BeadName, Impulse> BeadExchange::collect(std::span<const BeadOnLattice> beads) {
  std::vector<OutgoingMessage> to_peers(peers_.size());
  for (const BeadOnLattice& bead : beads) {
    const auto peer = std::ranges::lower_bound(peers_, bead.owner) - peers_.begin();
    to_peers[peer](bead.name, bead.impulse);
  }
  std::map<BeadName, Impulse> totals;
  for (IncomingMessage& message : exchange(to_peers, collect_tag)) {
    while (!message.is_at_end()) {
      BeadName name;
      Impulse impulse;
      message(name, impulse);
      totals[name].add(impulse);
    }
  }
  return totals;
}

std::vector<IncomingMessage> BeadExchange::exchange(const std::vector<OutgoingMessage>& to_peers, int tag) {
  std::vector<MPI_Request> requests;
  for (std::size_t p = 0; p < peers_.size(); ++p) {
    if (peers_[p] == rank_) continue;
    const std::vector<char>& bytes = to_peers[p].bytes();
    MPI_Isend(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, peers_[p], tag, comm_,
              &requests.emplace_back());
    traffic_.add_message(std::ssize(bytes));
  }
  std::vector<IncomingMessage> from_peers;
  for (std::size_t p = 0; p < peers_.size(); ++p) {
    std::vector<char> bytes;
    if (peers_[p] == rank_) {
      bytes = to_peers[p].bytes();
    } else {
      MPI_Status status;
      MPI_Probe(peers_[p], tag, comm_, &status);
      int size = 0;
      MPI_Get_count(&status, MPI_BYTE, &size);
      bytes.resize(size);
      MPI_Recv(bytes.data(), size, MPI_BYTE, peers_[p], tag, comm_, MPI_STATUS_IGNORE);
    }
    from_peers.emplace_back(std::move(bytes));
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  return from_peers;
}

}  // namespace beadswim
