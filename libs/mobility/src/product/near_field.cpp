#include "beadswim/mobility/near_field.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "beadswim/core/cell_list.hpp"
#include "near_strain.hpp"

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
  return fading(distance, full_weight_distance, pair_cutoff);
}

double strain_weight(double distance) {
  return pair_weight(distance / strain_reach);
}

NearField::NearField(std::vector<double> radii, std::vector<int> lines, double viscosity, Domain domain)
    : radii_(std::move(radii)),
      lines_(std::move(lines)),
      line_of_(radii_.size(), -1),
      viscosity_(viscosity),
      domain_(domain),
      lengths_(mirrored_lengths(domain.box)) {
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

NearMap NearField::at(std::span<const Vec3> positions) {
  NearLinks links{.beads = radii_.size()};
  NearStrains strains(radii_, viscosity_, domain_.half_space, positions, links);
  for (std::size_t line = 0; line < lines_.size(); ++line) {
    links.lines.push_back(line_link(line, positions));
    for (int i = lines_[line]; i < lines_[line] + 3; ++i)
      for (int j = i + 1; j < lines_[line] + 3; ++j) {
        const Vec3 separation = positions[i] - positions[j];
        const double weight = strain_weight(2 * separation.norm() / (radii_[i] + radii_[j]));
        if (weight != 0) strains.add(i, j, separation, false, Vec3::Ones(), weight);
      }
  }
  add_pairs(positions, strains, links.pairs);
  return NearMap(std::move(links));
}

LineLink NearField::line_link(std::size_t line, std::span<const Vec3> positions) {
  const int first = lines_[line];
  const Vec3* x = &positions[first];
  const double* radius = &radii_[first];
  const std::array<double, 2> gaps{(x[1] - x[0]).norm() - radius[0] - radius[1],
                                   (x[2] - x[1]).norm() - radius[1] - radius[2]};
  const LineMap<3> map = triplet_tables_[triplet_table_of_[line]].at(gaps, strain_weight);
  return {first, direction(x[2] - x[0]), map.map - Eigen::Matrix3d::Identity(), map.tow_defect / viscosity_};
}

NearField::Images NearField::mirror_images(std::span<const Vec3> positions) const {
  Images images{{positions.begin(), positions.end()}, {Vec3::Ones()}};
  for (auto* vectors : {&images.places, &images.mirrors}) add_mirror_images(domain_.box, *vectors);
  return images;
}

/// Adds the corrections of all close pairs of beads, and of beads and images.
void NearField::add_pairs(std::span<const Vec3> positions, NearStrains& strains,
                          std::vector<PairLink>& links) {
  links.reserve(positions.size());
  const Images images = mirror_images(positions);
  const double cutoff = strain_reach * pair_cutoff * *std::ranges::max_element(radii_);
  const CellList cells(images.places, cutoff, lengths_);
  const std::vector<int>& order = cells.order();
  const FoldedPositions folded(images.places, order, lengths_);
  const int beads = static_cast<int>(radii_.size());
  const auto add = [&](int one, int other, const Vec3& separation, bool is_direct) {
    if (is_direct && other < beads && line_of_[one] >= 0 && line_of_[one] == line_of_[other]) return;
    const int partner = other % beads;
    const double distance = 2 * separation.norm() / (radii_[one] + radii_[partner]);
    const double weight = pair_weight(distance), of_strains = strain_weight(distance);
    if (of_strains == 0) return;
    const Vec3& mirror = images.mirrors[other / beads];
    strains.add(one, partner, separation, other >= beads, mirror, of_strains);
    if (weight != 0) links.push_back(pair_link(images, one, other, separation, weight));
  };
  for (int s = 0; s < std::ssize(order); ++s) {
    for_each_image(Vec3::Zero(), lengths_, cutoff, [&](const Vec3& separation, bool) {
      // One link stands for the periodic images of the bead itself on both sides.
      const Vec3 reversed = -separation;
      if (order[s] < beads && std::ranges::lexicographical_compare(reversed, separation))
        add(order[s], order[s], separation, false);
    });
    cells.for_each_range_after(s, [&](int begin, int end) {
      for (int t = begin; t < end; ++t) {
        if (!folded.are_within(cutoff, s, t)) continue;
        const auto [one, other] = std::minmax(order[s], order[t]);
        if (one >= beads) continue;
        for_each_image(
            images.places[one] - images.places[other], lengths_, cutoff,
            [&](const Vec3& separation, bool is_direct) { add(one, other, separation, is_direct); });
      }
    });
  }
}

/// Returns the correction of two beads, or of a bead and a mirror image of a bead. `one` and `other` are
/// indices into Images::places, the former of a bead.
PairLink NearField::pair_link(const Images& images, int one, int other, const Vec3& separation,
                              double weight) {
  const int beads = static_cast<int>(radii_.size()), partner = other % beads;
  const auto [map, tow_defect] =
      pair_table(one, partner).at({separation.norm() - radii_[one] - radii_[partner]}, pair_weight);
  const LineMatrix<2> log = log_of_pair_map(map);
  return {.bead = one,
          .partner = partner,
          .is_image = other >= beads,
          .mirror = images.mirrors[other / beads],
          .axis = direction(separation),
          .own = weight * log(0, 0),
          .other = weight * log(0, 1),
          .tow_defect = weight * tow_defect / viscosity_};
}

LineMapTable<2>& NearField::pair_table(int bead, int partner) {
  const std::array<double, 2> radii{radii_[bead], radii_[partner]};
  return pair_tables_.try_emplace(radii, radii).first->second;
}

}  // namespace beadswim
