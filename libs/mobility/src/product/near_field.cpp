#include "beadswim/mobility/near_field.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "beadswim/core/cell_list.hpp"

namespace beadswim {
namespace {

/// Positions, wrapped into the periodic box and sorted by their cells. They allow a fast test of distances.
class FoldedPositions {
 public:
  FoldedPositions(std::span<const Vec3> places, std::span<const int> order, const Vec3& lengths) {
    places_.reserve(order.size());
    for (int a = 0; a < 3; ++a) lengths_[a] = lengths[a] > 0 ? lengths[a] : INFINITY;
    for (const int p : order) {
      places_.push_back(places[p]);
      for (int a = 0; a < 3; ++a)
        if (lengths[a] > 0) places_.back()[a] -= lengths[a] * std::floor(places[p][a] / lengths[a]);
    }
  }

  /// Returns true if the smallest distance between periodic images of points s and t is below the cutoff
  /// [length]. A margin of 1e-9 covers roundoff.
  bool are_within(double cutoff, int s, int t) const {
    const Vec3 direct = (places_[s] - places_[t]).cwiseAbs();
    return direct.cwiseMin(lengths_ - direct).squaredNorm() < (1 + 1e-9) * cutoff * cutoff;
  }

 private:
  Vec3 lengths_;
  std::vector<Vec3> places_;
};

/// Calls visit(separation, is_direct) for each periodic image of the vector `direct` between two beads that
/// is shorter than `cutoff`. is_direct is true for `direct` itself. `lengths`: edges of the periodic box
/// [length], 0 in open space.
template <class Visitor>
void for_each_image(const Vec3& direct, const Vec3& lengths, double cutoff, const Visitor& visit) {
  Vec3 nearest = direct, edges = Vec3::Zero();
  std::array<double, 3> around{};  // per axis: images beyond the nearest that may be within the cutoff
  for (int a = 0; a < 3; ++a) {
    if (lengths[a] == 0) continue;
    edges[a] = -std::nearbyint(direct[a] / lengths[a]);
    nearest[a] += edges[a] * lengths[a];
    around[a] = std::floor(cutoff / lengths[a] + 0.5);
  }
  for (double x = -around[0]; x <= around[0]; ++x)
    for (double y = -around[1]; y <= around[1]; ++y)
      for (double z = -around[2]; z <= around[2]; ++z) {
        const Vec3 farther(x, y, z);
        const Vec3 separation = nearest + farther.cwiseProduct(lengths);
        if (separation.squaredNorm() < cutoff * cutoff) visit(separation, (edges + farther).isZero(0));
      }
}

Vec3 direction(const Vec3& separation) {
  const double length = separation.norm();
  return length > 0 ? Vec3(separation / length) : Vec3::UnitX();
}

}  // namespace

double pair_weight(double distance) {
  if (distance <= full_weight_distance) return 1;
  if (distance >= pair_cutoff) return 0;
  const double t = (distance - full_weight_distance) / (pair_cutoff - full_weight_distance);
  return 1 - t * t * t * (10 - 15 * t + 6 * t * t);
}

NearField::NearField(std::vector<double> radii, std::vector<int> lines, std::optional<Box> box,
                     std::optional<HalfSpace> half_space)
    : radii_(std::move(radii)),
      lines_(std::move(lines)),
      line_of_(radii_.size(), -1),
      box_(box),
      half_space_(half_space),
      lengths_(mirrored_lengths(box)) {
  std::map<std::array<double, 3>, int> tables;
  for (std::size_t line = 0; line < lines_.size(); ++line) {
    const int b = lines_[line];
    std::fill_n(line_of_.begin() + b, 3, static_cast<int>(line));
    const std::array<double, 3> own{radii_[b], radii_[b + 1], radii_[b + 2]};
    const auto [table, is_new] = tables.try_emplace(own, static_cast<int>(triplet_tables_.size()));
    if (is_new) triplet_tables_.emplace_back(own);
    triplet_table_of_.push_back(table->second);
  }
}

NearMap NearField::at(std::span<const Vec3> positions) const {
  std::vector<LineLink> lines;
  lines.reserve(lines_.size());
  for (std::size_t line = 0; line < lines_.size(); ++line) lines.push_back(line_link(line, positions));
  return {std::move(lines), pair_links(positions), wall_links(positions), radii_.size()};
}

LineLink NearField::line_link(std::size_t line, std::span<const Vec3> positions) const {
  const int first = lines_[line];
  const Vec3* x = &positions[first];
  const double* radius = &radii_[first];
  const std::array<double, 2> gaps{(x[1] - x[0]).norm() - radius[0] - radius[1],
                                   (x[2] - x[1]).norm() - radius[1] - radius[2]};
  return {first, direction(x[2] - x[0]), triplet_tables_[triplet_table_of_[line]].change(gaps)};
}

NearField::Images NearField::mirror_images(std::span<const Vec3> positions) const {
  Images images{{positions.begin(), positions.end()}, {Vec3::Ones()}};
  for (auto* vectors : {&images.places, &images.mirrors}) add_mirror_images(box_, *vectors);
  return images;
}

std::vector<PairLink> NearField::pair_links(std::span<const Vec3> positions) const {
  std::vector<PairLink> links;
  links.reserve(positions.size());
  const Images images = mirror_images(positions);
  const double cutoff = pair_cutoff * *std::ranges::max_element(radii_);
  const CellList cells(images.places, cutoff, lengths_);
  const std::vector<int>& order = cells.order();
  const FoldedPositions folded(images.places, order, lengths_);
  const int beads = static_cast<int>(radii_.size());
  for (int s = 0; s < std::ssize(order); ++s)
    cells.for_each_range_after(s, [&](int begin, int end) {
      for (int t = begin; t < end; ++t) {
        if (!folded.are_within(cutoff, s, t)) continue;
        const int one = order[s], other = order[t];
        if (one >= beads && other >= beads) continue;
        for_each_image(images.places[one] - images.places[other], lengths_, cutoff,
                       [&](const Vec3& separation, bool is_direct) {
                         if (!is_direct || one >= beads || other >= beads || line_of_[one] < 0 ||
                             line_of_[one] != line_of_[other])
                           add_pair(images, one, other, separation, links);
                       });
      }
    });
  return links;
}

/// Adds the near-field correction of two beads, or of a bead and a mirror image of a bead, to `links`. `one`
/// and `other` are indices into Images::places.
void NearField::add_pair(const Images& images, int one, int other, const Vec3& separation,
                         std::vector<PairLink>& links) const {
  const int beads = static_cast<int>(radii_.size());
  if (one >= beads) return add_pair(images, other, one, -separation, links);
  const int partner = other % beads;
  const double sum = radii_[one] + radii_[partner], distance = separation.norm();
  const double weight = pair_weight(2 * distance / sum);
  if (weight == 0) return;
  const Eigen::RowVector2d row = weight * pair_table(one, partner).log_map(distance - sum);
  links.push_back({.bead = one,
                   .partner = partner,
                   .is_image = other >= beads,
                   .mirror = images.mirrors[other / beads],
                   .axis = direction(separation),
                   .own = row[0],
                   .other = row[1]});
}

std::vector<WallLink> NearField::wall_links(std::span<const Vec3> positions) const {
  std::vector<WallLink> links;
  if (!half_space_) return links;
  for (std::size_t b = 0; b < radii_.size(); ++b)
    if (const double log = wall_table_.log_map(half_space_->height(positions[b]) / radii_[b]); log != 0)
      links.push_back({static_cast<int>(b), Vec3::Unit(half_space_->axis), log});
  return links;
}

const PairMapTable& NearField::pair_table(int bead, int partner) const {
  const std::array<double, 2> radii{radii_[bead], radii_[partner]};
  const auto found = pair_tables_.find(radii);
  return found != pair_tables_.end() ? found->second
                                     : pair_tables_.try_emplace(radii, PairMapTable(radii)).first->second;
}

}  // namespace beadswim
