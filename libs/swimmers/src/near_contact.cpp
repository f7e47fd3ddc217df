#include "beadswim/swimmers/near_contact.hpp"

#include <algorithm>
#include <utility>

namespace beadswim {
namespace {

/// Returns the root of an increasing function between low and high, by bisection to the last bit.
template <class Function>
double find_root(const Function& increasing, double low, double high) {
  for (double middle = 0.5 * (low + high); low < middle && middle < high; middle = 0.5 * (low + high)) {
    (increasing(middle) < 0 ? low : high) = middle;
  }
  return high;
}

/// Parameters of the motion along the line of centres.
struct Approach {
  double gap, reduced_mass, stiffness, damping;
  double film;  ///< factor that limits the resistance of the film, 0 to 1
};

/// Repulsive impulses along the line of centres: film and contact together, and contact alone.
struct NormalImpulse {
  double total, contact;
};

NormalImpulse normal_impulse(const NearContactLaw& law, const CloseBead& first, const CloseBead& second,
                             const Approach& pair, double velocity, double step) {
  const auto contact_force = [&](double v) {
    const double overlap = -(pair.gap + step * v);
    return overlap > 0 ? std::max(0.0, pair.stiffness * overlap - pair.damping * v) : 0.0;
  };
  const auto momentum = [&](double h) {
    return pair.film * squeezing(first.radius, second.radius, law.viscosity, law.range, h).momentum;
  };
  const double momentum_now = momentum(pair.gap);
  const auto excess = [&](double v) {
    return pair.reduced_mass * (v - velocity) + momentum(pair.gap + step * v) - momentum_now -
           step * contact_force(v);
  };
  if (excess(velocity) == 0) return {.total = 0, .contact = 0};
  const double end = find_root(excess, std::min(velocity, 0.0), std::max({velocity, -pair.gap / step, 0.0}));
  const double total = pair.reduced_mass * (end - velocity);
  const double by_film = momentum_now - momentum(pair.gap + step * end);
  return {.total = total, .contact = std::max(0.0, total - by_film)};
}

/// Angular velocities w of the beads relative to the line of centres, and mobilities that relate the
/// velocities to impulses. I: moment of inertia of a bead; m: reduced mass; r: distance of the centres;
/// pairs: CloseBead::pairs.
struct PairRotation {
  Vec3 first, second;                                     ///< w, perpendicular to the line
  double first_mobility, second_mobility, line_mobility;  ///< pairs/I, pairs/I, 1/(m r^2)

  /// Applies angular impulses to the beads, balanced by forces perpendicular to the line of centres.
  void apply(const Vec3& on_first, const Vec3& on_second) {
    const Vec3 of_line = line_mobility * (on_first + on_second);
    first += first_mobility * on_first + of_line;
    second += second_mobility * on_second + of_line;
  }
};

/// Angular impulses on the two beads.
struct AngularImpulses {
  Vec3 first, second;
};

/// Returns the angular impulses -C w of the film on the two beads, where w are the angular velocities at the
/// end of the step and C = step ((c_aa, c_ab), (c_ab, c_bb)) contains the coefficients `film`. Solves
///   (1 + M C) w = w*
/// w* are the angular velocities without the film, and M is the change of w per angular impulse
/// (near_contact.hpp).
AngularImpulses film_angular_impulses(const PairRotation& w, const Sliding& film, double step) {
  // clang-format off
  const double c11 = step * film.aa, c12 = step * film.ab, c22 = step * film.bb;
  const double m11 = w.first_mobility  + w.line_mobility;
  const double m12 = w.line_mobility;
  const double m22 = w.second_mobility + w.line_mobility;
  const double a11 = 1 + m11 * c11 + m12 * c12,   a12 =     m11 * c12 + m12 * c22;
  const double a21 =     m12 * c11 + m22 * c12,   a22 = 1 + m12 * c12 + m22 * c22;
  const double determinant = a11 * a22 - a12 * a21;
  const Vec3 first  = (a22 * w.first  - a12 * w.second) / determinant;
  const Vec3 second = (a11 * w.second - a21 * w.first)  / determinant;
  return {-c11 * first - c12 * second,
          -c12 * first - c22 * second};
  // clang-format on
}

/// Returns the angular impulses of friction. Friction stops the sliding of the surfaces at the point of
/// contact if an impulse of at most `max_impulse` suffices. Otherwise the friction impulse is `max_impulse`.
/// The sliding velocity is n x (r_a w_a + r_b w_b), where n is the unit vector along the line of centres, w_a
/// and w_b are the angular velocities of the beads relative to this line, and r_a and r_b are the distances
/// of the point of contact from the centres.
AngularImpulses friction_angular_impulses(const PairRotation& w, double r_a, double r_b, double max_impulse) {
  const Vec3 sliding = r_a * w.first + r_b * w.second;
  const double mobility = r_a * r_a * w.first_mobility + r_b * r_b * w.second_mobility +
                          (r_a + r_b) * (r_a + r_b) * w.line_mobility;
  const double speed = sliding.norm();
  if (speed == 0) return {Vec3::Zero(), Vec3::Zero()};
  const Vec3 impulse = -std::min(speed / mobility, max_impulse) / speed * sliding;
  return {r_a * impulse, r_b * impulse};
}

}  // namespace

PairImpulse near_contact_impulse(const NearContactLaw& law, const CloseBead& first, const CloseBead& second,
                                 const Vec3& separation, double step) {
  const double a = first.radius, b = second.radius, distance = separation.norm();
  const Vec3 n = separation / distance;
  const Vec3 velocity = second.velocity - first.velocity;
  const double gap = distance - a - b;
  const double reduced_mass_shared = 1 / (first.pairs / first.mass + second.pairs / second.mass);
  const double reduced_mass_alone = 1 / (1 / first.mass + 1 / second.mass);
  // If a bead has several close pairs, the resistance of the film is limited, because the impulses of the
  // other pairs are known only from the previous step (near_contact.hpp).
  const double other_pairs = std::max(first.pairs, second.pairs) - 1;
  const auto limit_fraction = [&](double resistance, double mobility) {
    return other_pairs * step * resistance * mobility > 1 ? 1 / (other_pairs * step * resistance * mobility)
                                                          : 1.0;
  };
  const double resistance = squeezing(a, b, law.viscosity, law.range, gap).resistance;
  Approach approach{.gap = gap,
                    .reduced_mass = reduced_mass_shared,
                    .stiffness = reduced_mass_alone * law.stiffness_rate * law.stiffness_rate,
                    .damping = 2 * law.damping_ratio * reduced_mass_alone * law.stiffness_rate,
                    .film = limit_fraction(resistance, 1 / reduced_mass_alone)};
  const double spring = gap < 0 ? step * approach.stiffness + approach.damping : 0;
  const double taken = step * (resistance + spring) / reduced_mass_alone;
  const NormalImpulse push = normal_impulse(law, first, second, approach, velocity.dot(n), step);

  const auto perpendicular_part = [&](const Vec3& v) -> Vec3 { return v - v.dot(n) * n; };
  const Vec3 line_rotation = n.cross(velocity) / distance;
  PairRotation rotation{.first = perpendicular_part(first.angular_velocity) - line_rotation,
                        .second = perpendicular_part(second.angular_velocity) - line_rotation,
                        .first_mobility = first.pairs / first.inertia,
                        .second_mobility = second.pairs / second.inertia,
                        .line_mobility = 1 / (reduced_mass_shared * distance * distance)};
  const Sliding film = sliding(a, b, law.viscosity, law.range, gap);
  const double rate = film.aa / first.inertia + film.bb / second.inertia;
  AngularImpulses angular_impulses = film_angular_impulses(rotation, film, step * limit_fraction(rate, 1));
  if (push.contact > 0) {
    rotation.apply(angular_impulses.first, angular_impulses.second);
    const double r_a = distance * a / (a + b);
    const AngularImpulses friction =
        friction_angular_impulses(rotation, r_a, distance - r_a, law.friction * push.contact);
    angular_impulses.first += friction.first;
    angular_impulses.second += friction.second;
  }
  const Vec3 both = angular_impulses.first + angular_impulses.second;
  return {.linear = push.total * n + n.cross(both) / distance,
          .first_angular = angular_impulses.first,
          .second_angular = angular_impulses.second,
          .removed_fraction = taken / (1 + taken)};
}

SwimmerContact swimmer_contact(const NearContactLaw& law, std::span<const CloseBead> beads,
                               std::span<const Vec3> positions, double step) {
  struct ClosePair {
    std::size_t first, second;
    PairImpulse impulse;
  };
  const std::size_t n = beads.size();
  std::vector<ClosePair> pairs;
  for (std::size_t apart = 1; apart < n; ++apart) {  // neighbours in the list come first
    for (std::size_t i = 0; i + apart < n; ++i) {
      const std::size_t j = i + apart;
      if ((positions[j] - positions[i]).norm() - beads[i].radius - beads[j].radius < law.cutoff())
        pairs.push_back({i, j, {}});
    }
  }
  SwimmerContact result{.linear = std::vector<Vec3>(n, Vec3::Zero()),
                        .angular = std::vector<Vec3>(n, Vec3::Zero()),
                        .removed_fraction = std::vector<double>(n)};
  const auto sum_up = [&] {
    std::ranges::fill(result.linear, Vec3::Zero());
    std::ranges::fill(result.angular, Vec3::Zero());
    for (const ClosePair& pair : pairs) {
      result.linear[pair.first] -= pair.impulse.linear;
      result.linear[pair.second] += pair.impulse.linear;
      result.angular[pair.first] += pair.impulse.first_angular;
      result.angular[pair.second] += pair.impulse.second_angular;
    }
  };
  const auto moved = [&](std::size_t b) {
    CloseBead bead = beads[b];
    bead.pairs = 1;
    bead.velocity += result.linear[b] / bead.mass;
    bead.angular_velocity += result.angular[b] / bead.inertia;
    return bead;
  };
  double scale = 0;
  for (const CloseBead& bead : beads) scale = std::max(scale, bead.mass * bead.velocity.norm());
  constexpr int max_sweeps = 50;
  constexpr double roundoff = 1e-14;
  const bool is_alone = pairs.size() == 1;  // a single pair needs no iteration
  for (int sweep = 0; sweep < (is_alone ? 1 : max_sweeps); ++sweep) {
    double change = 0;
    for (ClosePair& pair : pairs) {
      const PairImpulse before = std::exchange(pair.impulse, {});
      sum_up();
      pair.impulse = near_contact_impulse(law, moved(pair.first), moved(pair.second),
                                          positions[pair.second] - positions[pair.first], step);
      change = std::max(change, (pair.impulse.linear - before.linear).norm());
    }
    if (change <= roundoff * scale) break;
  }
  sum_up();
  for (const ClosePair& pair : pairs) {
    result.removed_fraction[pair.first] += pair.impulse.removed_fraction;
    result.removed_fraction[pair.second] += pair.impulse.removed_fraction;
  }
  return result;
}

}  // namespace beadswim
