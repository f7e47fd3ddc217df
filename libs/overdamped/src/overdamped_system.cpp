#include "beadswim/overdamped/overdamped_system.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "beadswim/bodies/rest_positions.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/rank_share.hpp"
#include "swimmer_response.hpp"

namespace beadswim {
namespace {

/// g over what a swimmer alone answers with: stable where swimmers together answer 0.65 to 1.5 times as much.
constexpr double implicit_share = 1.3;

/// Sweeps of the first two steps: each gains an order, up to the fourth.
constexpr int sweeps = 6;

std::vector<double> radii_of(const OverdampedScene& scene) {
  std::vector<double> radii;
  for (std::size_t s = 0; s < scene.swimmers.size(); ++s)
    for (const Bead& bead : scene.type_of(s).beads) radii.push_back(bead.radius);
  return radii;
}

std::vector<Vec3> rest_places(const OverdampedScene& scene) {
  std::vector<Vec3> places;
  for (std::size_t s = 0; s < scene.swimmers.size(); ++s) {
    const auto& [id, type, position, axis] = scene.swimmers[s];
    for (const Vec3& place : rest_positions(scene.types[type], position, axis)) places.push_back(place);
  }
  return places;
}

BeadVectors beads_of(const std::vector<Vec3>& all, std::size_t swimmer) {
  return {all[3 * swimmer], all[3 * swimmer + 1], all[3 * swimmer + 2]};
}

Vector9 own_of(const std::vector<Vec3>& all, std::size_t swimmer) {
  return Eigen::Map<const Vector9>(all[3 * swimmer].data());
}

bool are_finite(const std::vector<Vec3>& vectors) {
  return std::ranges::all_of(vectors, [](const Vec3& v) { return v.allFinite(); });
}

double root_mean_square(const std::vector<Vec3>& vectors) {
  double sum = 0;
  for (const Vec3& v : vectors) sum += v.squaredNorm();
  return std::sqrt(sum / static_cast<double>(vectors.size()));
}

}  // namespace

OverdampedSystem::OverdampedSystem(OverdampedScene scene, const Communicator& communicator)
    : scene_(std::move(scene)),
      communicator_(communicator),
      radii_(radii_of(scene_)),
      contact_scale_(scene_),
      mobility_({scene_.model, scene_.viscosity, scene_.box, radii_, scene_.tolerance}, rest_places(scene_),
                communicator) {
  for (const SwimmerType& type : scene_.types)
    for (const Spring& spring : type.springs) has_dashpots_ = has_dashpots_ || spring.damping > 0;
  state_.positions.fill(rest_places(scene_));
  state_.velocities.fill(Beads(radii_.size(), Vec3::Zero()));
  if (has_dashpots_) state_.distant.assign(radii_.size(), Vec3::Zero());
  contacts_ = contacts_of(state_.positions[0]);
  state_.velocities[0] = velocities_at(state_.positions[0], 0, contacts_);
  note_extremes();
}

std::pair<std::size_t, std::size_t> OverdampedSystem::own_swimmers() const {
  return rank_share(std::ssize(scene_.swimmers), communicator_.rank(), communicator_.size());
}

Contacts OverdampedSystem::contacts_of(const Beads& positions) const {
  return find_contacts(contact_scale_, scene_.box, radii_, positions);
}

/// All but dashpots'.
OverdampedSystem::Beads OverdampedSystem::forces(const Beads& positions, double time,
                                                 const Contacts& contacts) const {
  Beads forces;
  forces.reserve(positions.size());
  const BeadVectors at_rest{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  for (std::size_t s = 0; s < scene_.swimmers.size(); ++s) {
    const SwimmerType& type = scene_.type_of(s);
    const BeadVectors beads = beads_of(positions, s);
    const BeadVectors springs = spring_forces(type.springs, beads, at_rest);
    const BeadVectors bending = angular_spring_forces(type.angular_stiffness, beads);
    const BeadVectors driving = driving_forces(type.driving, time, beads, scene_.swimmers[s].axis);
    for (int b = 0; b < 3; ++b) forces.push_back(springs[b] + bending[b] + driving[b]);
  }
  for (const Contact& contact : contacts.list) {
    const Vec3 force = contact.law.force * contact.normal;
    forces[contact.first] += force;
    if (contact.second != contact.first) forces[contact.second] -= force;
  }
  return forces;
}

OverdampedSystem::Beads OverdampedSystem::velocities_at(const Beads& positions, double time,
                                                        const Contacts& contacts) {
  const Beads all = forces(positions, time, contacts);
  if (has_dashpots_) return velocities_with_dashpots(positions, all);
  Beads velocities(all.size());
  mobility_.apply(positions, all, velocities);
  ++state_.products;
  return velocities;
}

/// v = mu (F - C v), C within swimmers. With mu v = own + distant parts each swimmer's own is solved for,
/// (I + mu_own C) v = mu_own F + distant, and distant parts follow from the forces found, until they no
/// longer change.
OverdampedSystem::Beads OverdampedSystem::velocities_with_dashpots(const Beads& positions,
                                                                   const Beads& forces) {
  struct Own {
    Matrix9 mobility, damping;
    Eigen::PartialPivLU<Matrix9> solver;
  };
  std::vector<Own> own;
  for (std::size_t s = 0; s < scene_.swimmers.size(); ++s) {
    const BeadVectors beads = beads_of(positions, s);
    const Matrix9 mobility = own_mobility(scene_.type_of(s), beads, scene_.viscosity);
    const Matrix9 damping = own_damping(scene_.type_of(s), beads);
    own.push_back(
        {mobility, damping, Eigen::PartialPivLU<Matrix9>(Matrix9::Identity() + mobility * damping)});
  }
  Beads damped = forces, velocities(forces.size());
  constexpr int most = 100;
  double relative = INFINITY;
  for (int i = 0; i < most && relative > 0.1 * scene_.tolerance; ++i) {  // NaN is a fault, found later
    for (std::size_t s = 0; s < own.size(); ++s) {
      const Vector9 v = own[s].solver.solve(own[s].mobility * own_of(forces, s) + own_of(state_.distant, s));
      Eigen::Map<Vector9>(damped[3 * s].data()) = own_of(forces, s) - own[s].damping * v;
    }
    mobility_.apply(positions, damped, velocities);
    ++state_.products;
    double change = 0;
    for (std::size_t s = 0; s < own.size(); ++s) {
      const Vector9 distant = own_of(velocities, s) - own[s].mobility * own_of(damped, s);
      change += (distant - own_of(state_.distant, s)).squaredNorm();
      Eigen::Map<Vector9>(state_.distant[3 * s].data()) = distant;
    }
    relative = std::sqrt(change / static_cast<double>(velocities.size())) / root_mean_square(velocities);
    MPI_Bcast(&relative, 1, MPI_DOUBLE, 0, communicator_.get());  // one decision, whatever ranks' processors
  }
  if (relative > 0.1 * scene_.tolerance && !fault_)
    fault_ = {.kind = OverdampedFaultKind::dashpots, .step = state_.steps_done, .value = relative};
  return velocities;
}

/// g of one swimmer: of its springs and its own beads' contacts at any positions, and linearly of contacts
/// with others at the positions now.
struct OverdampedSystem::Implicit {
  const OverdampedScene& scene;
  ContactScale scale;
  const Beads& now;
  std::vector<Matrix9> contacts;  ///< stiffness by other swimmers, of this rank's

  Vector9 of(std::size_t s, std::size_t first, const Vector9& x) const {
    const SwimmerType& type = scene.type_of(s);
    const BeadVectors beads{x.segment<3>(0), x.segment<3>(3), x.segment<3>(6)};
    Vector9 force = own_forces(type, beads) - contacts[s - first] * (x - own_of(now, s));
    visit_contacts(type, beads, [&](int i, int j, const Vec3& normal, const ContactForce& law) {
      force.segment<3>(3 * i) += law.force * normal;
      force.segment<3>(3 * j) -= law.force * normal;
    });
    return implicit_share * own_mobility(type, beads, scene.viscosity) * force;
  }

  /// -dg/dx, mobility held.
  Matrix9 slope(std::size_t s, std::size_t first, const Vector9& x) const {
    const SwimmerType& type = scene.type_of(s);
    const BeadVectors beads{x.segment<3>(0), x.segment<3>(3), x.segment<3>(6)};
    Matrix9 stiffness = own_stiffness(type, beads) + contacts[s - first];
    visit_contacts(type, beads, [&](int i, int j, const Vec3& normal, const ContactForce& law) {
      const Eigen::Matrix3d along = law.stiffness * normal * normal.transpose();
      stiffness.block<3, 3>(3 * i, 3 * i) += along;
      stiffness.block<3, 3>(3 * j, 3 * j) += along;
      stiffness.block<3, 3>(3 * i, 3 * j) -= along;
      stiffness.block<3, 3>(3 * j, 3 * i) -= along;
    });
    return implicit_share * own_mobility(type, beads, scene.viscosity) * stiffness;
  }

  /// x of weight (x - from) - step g(x) = 0, by Newton's method; `guess`: where to begin.
  Vector9 solve(std::size_t s, std::size_t first, double weight, double step, const Vector9& from,
                Vector9 guess) const {
    constexpr int most = 20;
    const double enough = 1e-12 * scene.type_of(s).springs[0].rest_length;
    for (int i = 0; i < most; ++i) {
      const Vector9 residual = weight * (guess - from) - step * of(s, first, guess);
      const Matrix9 matrix = weight * Matrix9::Identity() + step * slope(s, first, guess);
      const Vector9 change = matrix.partialPivLu().solve(residual);
      guess -= change;
      if (!(change.norm() > enough)) break;  // NaN is a fault, found later
    }
    return guess;
  }

 private:
  template <class Visitor>
  void visit_contacts(const SwimmerType& type, const BeadVectors& beads, const Visitor& visit) const {
    for (const auto& [i, j] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
      const Vec3 d = beads[i] - beads[j];
      const double distance = d.norm(), sum = type.beads[i].radius + type.beads[j].radius;
      const ContactForce law = contact_force(distance - sum, scale.share * sum / 2, scale.strength);
      if (law.stiffness > 0) visit(i, j, d / distance, law);
    }
  }
};

OverdampedSystem::Implicit OverdampedSystem::implicit_part() const {
  const Beads& now = state_.positions[0];
  const auto [first, last] = own_swimmers();
  Implicit implicit{scene_, contact_scale_, now, std::vector<Matrix9>(last - first, Matrix9::Zero())};
  for (const Contact& c : contacts_.list) {
    if (c.first / 3 == c.second / 3 && !c.is_image) continue;  // g has its own
    // Twice on either side, as if the other bead moved as much the other way.
    const Eigen::Matrix3d along = 2 * c.law.stiffness * c.normal * c.normal.transpose();
    for (const int bead : {c.first, c.second}) {
      const std::size_t s = bead / 3;
      if (s >= first && s < last)
        implicit.contacts[s - first].block<3, 3>(3 * (bead % 3), 3 * (bead % 3)) += along;
      if (c.first == c.second) break;
    }
  }
  return implicit;
}

/// All in displacements from the positions now: coordinates may be large.
OverdampedSystem::Beads OverdampedSystem::multistep() {
  const auto& [x, x1, x2] = state_.positions;
  const auto& [v, v1, v2] = state_.velocities;
  const double h = scene_.step, weight = 11.0 / 6;
  const auto [first, last] = own_swimmers();
  const Implicit g = implicit_part();
  Beads next = x;
  for (std::size_t s = first; s < last; ++s) {
    const Vector9 y1 = own_of(x1, s) - own_of(x, s), y2 = own_of(x2, s) - own_of(x, s);
    const Vector9 rest = 3 * (own_of(v, s) - g.of(s, first, own_of(x, s))) -
                         3 * (own_of(v1, s) - g.of(s, first, own_of(x1, s))) + own_of(v2, s) -
                         g.of(s, first, own_of(x2, s));
    const Vector9 from = own_of(x, s) + (-1.5 * y1 + y2 / 3 + h * rest) / weight;
    const Vector9 ahead = own_of(x, s) - 3 * y1 + y2;
    Eigen::Map<Vector9>(next[3 * s].data()) = g.solve(s, first, weight, h, from, ahead);
  }
  share(next);
  return next;
}

/// Nodes 0, h/2, h; integrals of the parabola through the velocities there; g carries what a sweep changes.
OverdampedSystem::Beads OverdampedSystem::deferred_corrections() {
  const Beads x = state_.positions[0], v = state_.velocities[0];
  const double h = scene_.step;
  const auto [first, last] = own_swimmers();
  const Implicit g = implicit_part();
  Beads middle = x, end = x, v_middle = v, v_end = v;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    Beads new_middle = middle, new_end = end;
    for (std::size_t s = first; s < last; ++s) {
      const Vector9 f0 = own_of(v, s), f1 = own_of(v_middle, s), f2 = own_of(v_end, s);
      const auto corrected = [&](Beads& nodes, const Vector9& from, const Vector9& integral) {
        const Vector9 node = own_of(nodes, s);
        Eigen::Map<Vector9>(nodes[3 * s].data()) =
            g.solve(s, first, 1, h / 2, from + integral - h / 2 * g.of(s, first, node), node);
      };
      corrected(new_middle, own_of(x, s), h / 24 * (5 * f0 + 8 * f1 - f2));
      corrected(new_end, own_of(new_middle, s), h / 24 * (-f0 + 8 * f1 + 5 * f2));
    }
    share(new_middle);
    share(new_end);
    middle = new_middle;
    end = new_end;
    if (!are_finite(middle) || !are_finite(end)) break;  // a fault, found later
    v_middle = velocities_at(middle, time() + h / 2, contacts_of(middle));
    v_end = velocities_at(end, time() + h, contacts_of(end));
  }
  return end;
}

void OverdampedSystem::share(Beads& positions) const {
  const int ranks = communicator_.size();
  if (ranks == 1) return;
  std::vector<int> counts, starts;
  for (int r = 0; r < ranks; ++r) {
    const auto [first, last] = rank_share(std::ssize(scene_.swimmers), r, ranks);
    counts.push_back(static_cast<int>(9 * (last - first)));
    starts.push_back(static_cast<int>(9 * first));
  }
  MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, positions[0].data(), counts.data(), starts.data(),
                 MPI_DOUBLE, communicator_.get());
}

void OverdampedSystem::step() {
  if (fault_) {
    ++state_.steps_done;
    return;
  }
  Beads next = state_.steps_done < 2 ? deferred_corrections() : multistep();
  const Beads before = state_.positions[0];
  std::ranges::rotate(state_.positions, state_.positions.end() - 1);
  std::ranges::rotate(state_.velocities, state_.velocities.end() - 1);
  state_.positions[0] = std::move(next);
  ++state_.steps_done;
  look_for_faults(before);
  if (fault_) return;
  contacts_ = contacts_of(state_.positions[0]);
  state_.velocities[0] = velocities_at(state_.positions[0], time(), contacts_);
  note_extremes();
}

void OverdampedSystem::note_extremes() {
  for (const Vec3& v : state_.velocities[0]) state_.largest_speed = std::max(state_.largest_speed, v.norm());
  state_.smallest_gap = std::min(state_.smallest_gap, contacts_.smallest_gap);
}

/// All ranks have all beads and see the same.
void OverdampedSystem::look_for_faults(const Beads& before) {
  const Beads& now = state_.positions[0];
  const auto note = [&](OverdampedFaultKind kind, std::size_t bead, int number, double value) {
    if (!fault_)
      fault_ = {kind, state_.steps_done, scene_.swimmers[bead / 3].id, number, before[bead], value};
  };
  for (std::size_t b = 0; b < now.size(); ++b) {
    const double moved = (now[b] - before[b]).norm() / radii_[b];
    const int number = static_cast<int>(b % 3) + 1;
    if (!std::isfinite(moved)) note(OverdampedFaultKind::not_finite, b, number, moved);
    if (moved > 1) note(OverdampedFaultKind::speed, b, number, moved);
    for (int a = 0; a < 3 && scene_.box; ++a) {
      const double beyond = std::max(-now[b][a], now[b][a] - scene_.box->lengths[a]);
      if (scene_.box->free_slip[a] && beyond > 0) note(OverdampedFaultKind::wall, b, number, beyond);
    }
    if (number == 3) continue;
    const double length =
        (now[b + 1] - now[b]).norm() / scene_.type_of(b / 3).springs[number - 1].rest_length;
    if (length > 2) note(OverdampedFaultKind::torn_arm, b, number, length);
  }
}

void OverdampedSystem::restore(OverdampedState state) {
  const auto is_whole = [&](const Beads& list) { return list.size() == radii_.size(); };
  if (!std::ranges::all_of(state.positions, is_whole) || !std::ranges::all_of(state.velocities, is_whole) ||
      (has_dashpots_ && !is_whole(state.distant)))
    throw SolverError("the state is of another scene");
  state_ = std::move(state);
  contacts_ = contacts_of(state_.positions[0]);
}

}  // namespace beadswim
