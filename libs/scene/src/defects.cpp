#include "beadswim/scene/defects.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>

#include "beadswim/core/error.hpp"
#include "beadswim/core/keyed_random.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/scene/bead_gaps.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"

namespace beadswim {
namespace {

/// Purposes for which random numbers are used. KeyedRandom has a different sequence for each purpose, even
/// for equal seeds and equal ids. The values of this enumeration must not change, because the defects that a
/// seed generates depend on them.
enum Purpose : std::uint64_t { draw = 0, place, turn, region, offset, strength, frequency, layer };

KeyedRandom swimmer_random(const Swimmer& swimmer, std::uint64_t seed, Purpose purpose) {
  return {seed, static_cast<std::uint64_t>(swimmer.id), purpose};
}

std::size_t resolved_count(const ShareOrCount& share_or_count, std::size_t all, const std::string& things) {
  if (const auto* fraction = std::get_if<double>(&share_or_count))
    return static_cast<std::size_t>(std::lround(*fraction * static_cast<double>(all)));
  const auto count = static_cast<std::size_t>(std::get<std::int64_t>(share_or_count));
  if (count <= all) return count;
  throw InputError(Setting::count, "the count {} is greater than the number of {}, {}; reduce the count",
                   count, things, all);
}

/// Selects `count` of the indices 0 ... keys.size() - 1 at random: each key yields a random number, and the
/// indices with the smallest random numbers are selected. Returns them in ascending order. A key is the id of
/// a swimmer, or the number of a distance between layers.
std::vector<std::size_t> draw_keys(const std::vector<std::uint64_t>& keys, std::size_t count,
                                   std::uint64_t seed, Purpose purpose) {
  std::vector<std::pair<std::uint64_t, std::size_t>> tickets;
  for (std::size_t i = 0; i < keys.size(); ++i)
    tickets.emplace_back(KeyedRandom(seed, keys[i], purpose).bits(), i);
  std::ranges::sort(tickets);
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < count; ++i) result.push_back(tickets[i].second);
  std::ranges::sort(result);
  return result;
}

const Box& required_box(const Layout& layout, const char* defect) {
  if (layout.domain.box) return *layout.domain.box;
  throw InputError("/domain",
                   "the fluid is unbounded ({}), but {} requires a box; make the layout with {} X,Y,Z",
                   in_words(layout.domain), defect, Setting::box);
}

/// Returns the gap to other surfaces that the positions of added swimmers must have, and that displaced
/// swimmers should have [length].
double min_clearance(const Layout& layout) {
  return 0.1 * smallest_radius(layout);
}

double positive_factor(const Swimmer& swimmer, double factor, const char* what) {
  if (factor > 0) return factor;
  throw InputError(Setting::sigma,
                   "the random factor of the {} of swimmer {} is {:.3g}, but must be positive; reduce {} or "
                   "choose another {}",
                   what, swimmer.id, factor, Setting::sigma, Setting::seed);
}

/// Displacements that a swimmer whose beads are too close to other beads or to walls requires [length].
struct Push {
  Vec3 beads = Vec3::Zero();  ///< sum over the pairs of close beads
  int pairs = 0;
  Vec3 walls = Vec3::Zero();  ///< the largest along each axis
};

/// Gives the swimmer an axis. A swimmer with a turn of its own is turned by the shortest turn onto this axis.
void set_axis(Swimmer& swimmer, const Vec3& axis) {
  const Eigen::Quaterniond turn = shortest_turn(swimmer.axis, axis);
  if (swimmer.turn) swimmer.turn = (turn * *swimmer.turn).normalized();
  swimmer.turn_start(turn);
  swimmer.axis = axis;
}

/// Calls change(swimmer, driving, random) for each chosen swimmer, and stores the changed `driving` as the
/// swimmer's own driving. `random` yields random numbers that depend on the seed, on `purpose` and on the id
/// of the swimmer.
void change_driving(Layout& layout, const std::vector<std::size_t>& chosen, std::uint64_t seed,
                    Purpose purpose,
                    const std::function<void(const Swimmer&, Driving&, KeyedRandom&)>& change) {
  for (const std::size_t s : chosen) {
    Swimmer& swimmer = layout.swimmers[s];
    Driving driving = layout.driving_of(swimmer);
    KeyedRandom random = swimmer_random(swimmer, seed, purpose);
    change(swimmer, driving, random);
    swimmer.driving = driving;
  }
}

}  // namespace

std::vector<std::size_t> draw_swimmer_indices(const Layout& layout, const ShareOrCount& share_or_count,
                                              std::uint64_t seed) {
  std::vector<std::uint64_t> ids;
  for (const Swimmer& swimmer : layout.swimmers) ids.push_back(static_cast<std::uint64_t>(swimmer.id));
  return draw_keys(ids, resolved_count(share_or_count, ids.size(), "swimmers"), seed, Purpose::draw);
}

void add_vacancies(Layout& layout, const ShareOrCount& share_or_count, std::uint64_t seed) {
  const std::vector<std::size_t> gone = draw_swimmer_indices(layout, share_or_count, seed);
  if (gone.size() == layout.swimmers.size())
    throw InputError("vacancy", "the defect would remove all swimmers; reduce {} or {}", Setting::count,
                     Setting::fraction);
  std::size_t s = 0;
  std::erase_if(layout.swimmers, [&](const Swimmer&) { return std::ranges::binary_search(gone, s++); });
}

void add_interstitials(Layout& layout, const ShareOrCount& share_or_count, std::uint64_t seed) {
  const Box domain = required_box(layout, "an interstitial");
  std::vector<PlacedBead> beads = placed_beads(layout);
  const double clearance = min_clearance(layout);
  CellList cells = bead_cells(beads, layout.domain.box, clearance);
  std::size_t sorted = beads.size();  // number of beads in `cells`; beads added later are tested one by one

  const auto is_free = [&](const Vec3& centre, double radius) {
    for (int a = 0; a < 3; ++a) {
      if (domain.is_periodic(a)) continue;
      if (centre[a] < radius + clearance || centre[a] > domain.lengths[a] - radius - clearance) return false;
    }
    const auto is_clear_of = [&](std::size_t b) {
      const double distance = nearest_separation(centre, beads[b].centre, domain).norm();
      return distance > radius + beads[b].radius + clearance;
    };
    for (std::size_t b = sorted; b < beads.size(); ++b)
      if (!is_clear_of(b)) return false;
    return cells.visit_neighbours(centre, is_clear_of);
  };
  const std::size_t count = std::holds_alternative<double>(share_or_count)
                                ? resolved_count(share_or_count, layout.swimmers.size(), "swimmers")
                                : static_cast<std::size_t>(std::get<std::int64_t>(share_or_count));
  Swimmer added = layout.swimmers.front();
  added.driving.reset();
  added.start.reset();
  for (const Swimmer& swimmer : layout.swimmers) added.id = std::max(added.id, swimmer.id);
  const auto ids_left = static_cast<std::size_t>(std::numeric_limits<int>::max() - added.id);
  if (count > ids_left) {
    throw InputError(
        "interstitial",
        "the largest possible id is {}, and the swimmers have ids up to {}; give the swimmers smaller ids",
        std::numeric_limits<int>::max(), added.id);
  }
  const SwimmerType type = at_start(layout.types.at(added.type));
  constexpr int max_trials = 100000;
  for (std::size_t n = 0; n < count; ++n) {
    ++added.id;
    KeyedRandom random = swimmer_random(added, seed, Purpose::place);
    std::vector<Vec3> centres;
    int trials = 0;
    do {
      if (trials++ == max_trials)
        throw InputError(
            "interstitial",
            "no free place for swimmer {} was found in {} trials; the box is too full: add fewer swimmers",
            added.id, max_trials);
      for (int a = 0; a < 3; ++a) added.position[a] = domain.lengths[a] * random.uniform();
      centres = rest_positions(type, added.position, added.orientation());
    } while (!std::ranges::equal(centres, type.beads, is_free, {}, &Bead::radius));
    for (int b = 0; b < std::ssize(centres); ++b)
      beads.push_back({.centre = centres[b],
                       .radius = type.beads[b].radius,
                       .swimmer = layout.swimmers.size(),
                       .bead = b});
    layout.swimmers.push_back(added);
    constexpr std::size_t max_unsorted = 100;
    if (beads.size() - sorted > max_unsorted) {
      cells = bead_cells(beads, layout.domain.box, clearance);
      sorted = beads.size();
    }
  }
}

void jitter(Layout& layout, const std::vector<std::size_t>& chosen, double sigma, std::uint64_t seed) {
  for (const std::size_t s : chosen) {
    Swimmer& swimmer = layout.swimmers[s];
    KeyedRandom random = swimmer_random(swimmer, seed, Purpose::place);
    swimmer.move_to(wrapped(swimmer.position + sigma * random.normal3(), layout.domain.box));
  }
}

void rotate(Layout& layout, const std::vector<std::size_t>& chosen, std::optional<double> sigma,
            std::uint64_t seed) {
  for (const std::size_t s : chosen) {
    Swimmer& swimmer = layout.swimmers[s];
    KeyedRandom random = swimmer_random(swimmer, seed, Purpose::turn);
    if (!sigma) {
      set_axis(swimmer, random.direction());
      continue;
    }
    Vec3 across = random.direction().cross(swimmer.axis);
    while (across.norm() < 1e-3) across = random.direction().cross(swimmer.axis);
    const double angle = *sigma * random.normal();
    set_axis(swimmer, (std::cos(angle) * swimmer.axis + std::sin(angle) * across.normalized()).normalized());
  }
}

void add_domains(Layout& layout, std::int64_t domains, std::uint64_t seed) {
  const Box& box = required_box(layout, "a pattern of domains");
  std::vector<Vec3> points, directions;
  for (std::int64_t d = 0; d < domains; ++d) {
    KeyedRandom random(seed, static_cast<std::uint64_t>(d), Purpose::region);
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    points.push_back(box.lengths.cwiseProduct(Vec3(x, y, z)));
    directions.push_back(random.direction());
  }
  for (Swimmer& swimmer : layout.swimmers) {
    const auto distance = [&](const Vec3& point) {
      return nearest_separation(swimmer.position, point, layout.domain.box).norm();
    };
    const auto nearest = std::ranges::min_element(points, {}, distance) - points.begin();
    set_axis(swimmer, directions[nearest]);
  }
}

void disorder_phases(Layout& layout, const std::vector<std::size_t>& chosen, std::optional<double> sigma,
                     std::uint64_t seed) {
  change_driving(layout, chosen, seed, Purpose::offset,
                 [&](const Swimmer&, Driving& driving, KeyedRandom& random) {
                   driving.phase_offset +=
                       sigma ? *sigma * random.normal() : std::numbers::pi * (2 * random.uniform() - 1);
                   driving.phase_offset = std::remainder(driving.phase_offset, 2 * std::numbers::pi);
                 });
}

void disorder_amplitudes(Layout& layout, const std::vector<std::size_t>& chosen, double sigma,
                         std::uint64_t seed) {
  change_driving(layout, chosen, seed, Purpose::strength,
                 [&](const Swimmer& swimmer, Driving& driving, KeyedRandom& random) {
                   const double factor = positive_factor(swimmer, 1 + sigma * random.normal(), "amplitudes");
                   for_each_harmonic(driving, [&](Harmonic& harmonic) { harmonic.amplitude *= factor; });
                   for (ForceDrive& drive : driving.forces) drive.constant *= factor;
                 });
}

void disorder_frequencies(Layout& layout, const std::vector<std::size_t>& chosen, double sigma,
                          std::uint64_t seed) {
  change_driving(layout, chosen, seed, Purpose::frequency,
                 [&](const Swimmer& swimmer, Driving& driving, KeyedRandom& random) {
                   driving.period /= positive_factor(swimmer, 1 + sigma * random.normal(), "frequency");
                 });
}

void space_layers(Layout& layout, const LayerSpacing& spacing, const ShareOrCount& share_or_count,
                  std::uint64_t seed) {
  const int axis = spacing.axis;
  const bool periodic = layout.domain.box && layout.domain.box->is_periodic(axis);
  for (Swimmer& swimmer : layout.swimmers) swimmer.move_to(wrapped(swimmer.position, layout.domain.box));
  std::vector<std::size_t> order(layout.swimmers.size());
  std::iota(order.begin(), order.end(), 0);
  const auto height = [&](std::size_t s) { return layout.swimmers[s].position[axis]; };
  const auto raise = [&](std::size_t s, double by) {
    layout.swimmers[s].move_to(layout.swimmers[s].position + by * Vec3::Unit(axis));
  };
  std::ranges::sort(order, {}, [&](std::size_t s) { return height(s); });
  const double same = 1e-6 * smallest_radius(layout);
  if (periodic) {  // joins the two parts of a layer that lies at a periodic face
    const double length = layout.domain.box->lengths[axis];
    while (height(order.back()) > length - same && height(order.front()) < same) {
      raise(order.back(), -length);
      std::rotate(order.begin(), order.end() - 1, order.end());
    }
  }
  std::vector<std::vector<std::size_t>> layers;
  for (const std::size_t s : order) {
    if (layers.empty() || height(s) - height(layers.back().back()) > same) layers.emplace_back();
    layers.back().push_back(s);
  }

  // `numbers` contains the numbers of the distances between layers that may change. Distance n is between
  // layers n - 1 and n. Distance 0 exists only in a periodic box, between the image of the last layer and
  // layer 0.
  const std::size_t first = periodic ? 0 : 1;
  std::vector<std::uint64_t> numbers;
  for (std::size_t n = first; n < layers.size(); ++n) numbers.push_back(n);
  const std::vector<std::size_t> moved = draw_keys(
      numbers, resolved_count(share_or_count, numbers.size(), "gaps between layers"), seed, Purpose::draw);
  double shift = 0, before = periodic ? height(layers.back().front()) - layout.domain.box->lengths[axis] : 0;
  for (std::size_t n = 0; n < layers.size(); ++n) {
    const double here = height(layers[n].front());
    if (n >= first && std::ranges::binary_search(moved, n - first)) {
      double more = spacing.sigma * KeyedRandom(seed, n, Purpose::layer).normal();
      if (spacing.whole > 0) more = spacing.whole * std::round(more / spacing.whole);
      if (here - before + more <= 0) {
        throw InputError(Setting::sigma,
                         "two neighbours of the {} layers of swimmers are {:.4g} apart, and the random "
                         "change of this distance by {:.4g} would make the layers exchange places; reduce {} "
                         "or choose another {}, and apply jitter only after this defect",
                         layers.size(), here - before, more, Setting::sigma, Setting::seed);
      }
      shift += more;
    }
    before = here;
    for (const std::size_t s : layers[n]) raise(s, shift);
  }
  if (layout.domain.box) layout.domain.box->lengths[axis] += shift;
  for (Swimmer& swimmer : layout.swimmers) swimmer.move_to(wrapped(swimmer.position, layout.domain.box));
}

void repair_overlaps(Layout& layout) {
  constexpr int max_passes = 1000;
  const double clearance = min_clearance(layout);
  // Beads are displaced to a gap of `clearance`, but half of this gap is accepted, so that the iteration
  // ends.
  const double tolerance = 0.5 * clearance;
  for (int pass = 0; pass < max_passes; ++pass) {
    const std::vector<PlacedBead> beads = placed_beads(layout);
    std::vector<Push> pushes(layout.swimmers.size());
    bool any = false;
    for (const BeadPair& pair : close_pairs(beads, layout.domain.box, clearance)) {
      const PlacedBead &one = beads[pair.first], &other = beads[pair.second];
      const double missing_gap = one.radius + other.radius + clearance - pair.distance;
      if (one.swimmer == other.swimmer || missing_gap <= tolerance) continue;
      any = true;
      const Vec3 separation = nearest_separation(one.centre, other.centre, layout.domain.box);
      const Vec3 away = pair.distance > 0 ? Vec3(separation / pair.distance) : Vec3(Vec3::UnitZ());
      pushes[one.swimmer].beads += -0.5 * missing_gap * away;
      pushes[other.swimmer].beads += 0.5 * missing_gap * away;
      for (const std::size_t swimmer : {one.swimmer, other.swimmer}) ++pushes[swimmer].pairs;
    }
    const auto push_off_wall = [&](std::size_t swimmer, int axis, double push) {
      if (std::abs(push) <= tolerance) return;
      any = true;
      double& largest = pushes[swimmer].walls[axis];
      if (std::abs(push) > std::abs(largest)) largest = push;
    };
    for (const PlacedBead& bead : beads) {
      if (const auto& half_space = layout.domain.half_space) {
        const double upward = bead.radius + clearance - half_space->height(bead.centre);
        push_off_wall(bead.swimmer, half_space->axis, std::max(upward, 0.0));
      }
      for (int a = 0; layout.domain.box && a < 3; ++a) {
        if (layout.domain.box->is_periodic(a)) continue;
        const double low = bead.radius + clearance, high = layout.domain.box->lengths[a] - low;
        const double inward = std::clamp(bead.centre[a], low, std::max(low, high)) - bead.centre[a];
        push_off_wall(bead.swimmer, a, inward);
      }
    }
    if (!any) return;
    for (std::size_t s = 0; s < pushes.size(); ++s) {
      const Vec3 move = pushes[s].walls + pushes[s].beads / std::max(pushes[s].pairs, 1);
      layout.swimmers[s].move_to(wrapped(layout.swimmers[s].position + move, layout.domain.box));
    }
  }
  throw InputError(Setting::repair,
                   "beads are still too close to each other after {} attempts to move overlapping swimmers "
                   "apart; enlarge the box or reduce the defects",
                   max_passes);
}

}  // namespace beadswim
