// Tests of random defects: what they change, what they leave unchanged, their size, and that equal seeds give
// equal changes.
#include "beadswim/scene/defects.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "beadswim/core/error.hpp"
#include "beadswim/core/keyed_random.hpp"
#include "beadswim/scene/bead_gaps.hpp"
#include "beadswim/scene/check.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"
#include "swarm_scene.hpp"

namespace beadswim {
namespace {

/// Returns a swarm of 2250 swimmers.
Layout large_swarm() {
  SwarmPlan plan = paper_uniform_plan();
  plan.blocks = Index3(10, 5, 5);
  return swarm_of(plan, paper_swarm().types.at("a"));
}

std::set<int> ids_of(const Layout& layout) {
  std::set<int> ids;
  for (const Swimmer& swimmer : layout.swimmers) ids.insert(swimmer.id);
  return ids;
}

struct Moments {
  double mean = 0, deviation = 0;
};

Moments moments_of(const std::vector<double>& values) {
  Moments m;
  for (const double x : values) m.mean += x / static_cast<double>(values.size());
  for (const double x : values)
    m.deviation += (x - m.mean) * (x - m.mean) / static_cast<double>(values.size());
  m.deviation = std::sqrt(m.deviation);
  return m;
}

/// Checks that the values have mean 0 and standard deviation sigma, within five standard errors.
void expect_normal(const std::vector<double>& values, double sigma) {
  const double n = static_cast<double>(values.size());
  const Moments m = moments_of(values);
  EXPECT_NEAR(m.mean, 0, 5 * sigma / std::sqrt(n));
  EXPECT_NEAR(m.deviation, sigma, 5 * sigma / std::sqrt(2 * n));
}

// Deviates are normal, to the sixth moment, and directions alike. Seed 3.
TEST(KeyedRandom, IsNormalAndWithoutDirection) {
  std::vector<double> normals, cubes;
  Vec3 sum = Vec3::Zero(), squares = Vec3::Zero();
  constexpr int n = 20000;
  for (int i = 0; i < n; ++i) {
    KeyedRandom random(3, i, 0);
    normals.push_back(random.normal());
    cubes.push_back(std::pow(normals.back(), 3));
    const Vec3 direction = random.direction();
    EXPECT_NEAR(direction.norm(), 1, 1e-14);
    sum += direction;
    squares += direction.cwiseAbs2();
  }
  expect_normal(normals, 1);
  EXPECT_NEAR(moments_of(cubes).deviation, std::sqrt(15.0), 0.5);  // <x^6> = 15
  EXPECT_LT((sum / n).norm(), 5 / std::sqrt(n));
  EXPECT_LT((squares / n - Vec3::Constant(1.0 / 3)).norm(), 5 * 0.3 / std::sqrt(n));
}

// A fraction takes the nearest whole number, a count itself; the rest keep ids and places; another order of
// swimmers, the same choice.
TEST(Vacancies, TakeAsManyAsAskedFor) {
  const Layout swarm = large_swarm();
  Layout fewer = swarm, counted = swarm, reversed = swarm, other = swarm;
  add_vacancies(fewer, 0.1, 7);
  EXPECT_EQ(fewer.swimmers.size(), 2025);
  add_vacancies(counted, std::int64_t{225}, 7);
  EXPECT_EQ(ids_of(fewer), ids_of(counted));
  std::ranges::reverse(reversed.swimmers);
  add_vacancies(reversed, 0.1, 7);
  EXPECT_EQ(ids_of(fewer), ids_of(reversed));
  add_vacancies(other, 0.1, 8);
  EXPECT_NE(ids_of(fewer), ids_of(other));
  for (const Swimmer& swimmer : fewer.swimmers)
    EXPECT_EQ(swimmer.position, swarm.swimmers[swimmer.id].position);
  EXPECT_THROW(add_vacancies(fewer, 1.0, 1), InputError);
  EXPECT_THROW(add_vacancies(fewer, std::int64_t{2026}, 1), InputError);
}

TEST(Interstitials, GoWhereThereIsRoom) {
  Layout layout = large_swarm();
  add_interstitials(layout, std::int64_t{40}, 5);
  EXPECT_EQ(layout.swimmers.size(), 2290);
  EXPECT_EQ(*ids_of(layout).rbegin(), 2289);
  EXPECT_TRUE(check_layout(layout).empty());
  EXPECT_GT(smallest_gap(placed_beads(layout), layout.domain), 0.6 - 1e-9);
  // Spread over the box, not in a corner of it.
  Vec3 mean = Vec3::Zero();
  for (std::size_t s = 2250; s < 2290; ++s) mean += layout.swimmers[s].position / 40;
  EXPECT_LT((mean.cwiseQuotient(layout.domain.box->lengths) - Vec3::Constant(0.5)).norm(), 0.25);
  Layout full = swarm_of(paper_uniform_plan(), paper_swarm().types.at("a"));
  EXPECT_THROW(add_interstitials(full, std::int64_t{1000}, 5), InputError);
  Layout numbered = swarm_of(paper_uniform_plan(), paper_swarm().types.at("a"));
  numbered.swimmers.front().id = std::numeric_limits<int>::max();
  EXPECT_THROW(add_interstitials(numbered, std::int64_t{1}, 5), InputError);
}

TEST(Jitter, MovesByNormalDeviates) {
  const Layout swarm = large_swarm();
  Layout moved = swarm;
  jitter(moved, draw_swimmer_indices(moved, 1.0, 2), 0.3, 2);
  for (int a = 0; a < 3; ++a) {
    std::vector<double> shifts;
    for (std::size_t s = 0; s < swarm.swimmers.size(); ++s)
      shifts.push_back(moved.swimmers[s].position[a] - swarm.swimmers[s].position[a]);
    expect_normal(shifts, 0.3);
  }
  // Into the box through its periodic faces.
  Layout at_face = swarm;
  for (Swimmer& swimmer : at_face.swimmers) swimmer.position[1] = 1e-3;
  jitter(at_face, draw_swimmer_indices(at_face, 1.0, 2), 0.3, 2);
  for (const Swimmer& swimmer : at_face.swimmers) {
    EXPECT_GE(swimmer.position[1], 0);
    EXPECT_LE(swimmer.position[1], at_face.domain.box->lengths[1]);
  }
  // Half of them, and those as if all had been moved.
  Layout half = swarm;
  jitter(half, draw_swimmer_indices(half, 0.5, 2), 0.3, 2);
  int still = 0;
  for (std::size_t s = 0; s < swarm.swimmers.size(); ++s) {
    const bool stays = half.swimmers[s].position == swarm.swimmers[s].position;
    still += stays ? 1 : 0;
    if (!stays) {
      EXPECT_EQ(half.swimmers[s].position, moved.swimmers[s].position);
    }
  }
  EXPECT_EQ(still, 1125);
}

TEST(Rotation, TurnsByNormalAnglesOrToAllDirections) {
  Layout layout = large_swarm();
  rotate(layout, draw_swimmer_indices(layout, 1.0, 4), 0.05, 4);
  std::vector<double> across_y, across_z;
  for (const Swimmer& swimmer : layout.swimmers) {
    EXPECT_NEAR(swimmer.axis.norm(), 1, 1e-14);
    across_y.push_back(swimmer.axis[1]);
    across_z.push_back(swimmer.axis[2]);
  }
  expect_normal(across_y, 0.05 / std::numbers::sqrt2);  // the angle's line is random: half in each
  expect_normal(across_z, 0.05 / std::numbers::sqrt2);
  Layout far = large_swarm();
  rotate(far, draw_swimmer_indices(far, 1.0, 4), 0.5, 4);
  double squares = 0;
  for (const Swimmer& swimmer : far.swimmers) squares += std::pow(std::acos(swimmer.axis[0]), 2) / 2250;
  EXPECT_NEAR(std::sqrt(squares), 0.5, 5 * 0.5 / std::sqrt(2 * 2250.0));
  rotate(layout, draw_swimmer_indices(layout, 1.0, 4), std::nullopt, 4);
  Vec3 mean = Vec3::Zero();
  for (const Swimmer& swimmer : layout.swimmers) mean += swimmer.axis / 2250;
  EXPECT_LT(mean.norm(), 5 / std::sqrt(2250.0));
}

// Neighbours share a direction, also through the periodic faces; there are as many as asked for.
TEST(Domains, AreRegionsOfOneDirection) {
  Layout layout = large_swarm();
  add_domains(layout, 6, 9);
  std::vector<Vec3> directions;
  for (const Swimmer& swimmer : layout.swimmers) {
    const auto same = [&](const Vec3& known) { return (known - swimmer.axis).norm() < 1e-12; };
    if (std::ranges::none_of(directions, same)) directions.push_back(swimmer.axis);
  }
  EXPECT_EQ(directions.size(), 6);
  int alike = 0, pairs = 0;
  for (std::size_t s = 0; s < layout.swimmers.size(); ++s) {
    for (std::size_t t = 0; t < s; ++t) {
      Vec3 apart = layout.swimmers[s].position - layout.swimmers[t].position;
      for (int a = 0; a < 3; ++a)
        apart[a] -= layout.domain.box->lengths[a] * std::round(apart[a] / layout.domain.box->lengths[a]);
      if (apart.norm() > 33) continue;
      ++pairs;
      alike += layout.swimmers[s].axis == layout.swimmers[t].axis ? 1 : 0;
    }
  }
  EXPECT_EQ(pairs, 2 * 2250);
  EXPECT_GT(alike, 0.8 * pairs);
}

TEST(Driving, IsDisorderedSwimmerBySwimmer) {
  Layout layout = large_swarm();
  const auto all = draw_swimmer_indices(layout, 1.0, 1);
  disorder_phases(layout, all, 0.2, 1);
  disorder_amplitudes(layout, all, 0.1, 2);
  disorder_frequencies(layout, all, 0.05, 3);
  std::vector<double> offsets, strengths, frequencies;
  for (const Swimmer& swimmer : layout.swimmers) {
    const ThreeBeadDriving driving = three_beads(layout.resolved_type(swimmer)).driving;
    EXPECT_EQ(driving.phase, std::numbers::pi / 2);
    EXPECT_EQ(driving.amplitude[0], driving.amplitude[1]);
    offsets.push_back(driving.phase_offset);
    strengths.push_back(driving.amplitude[0] / 2 - 1);
    frequencies.push_back(2000 / driving.period - 1);
  }
  expect_normal(offsets, 0.2);
  expect_normal(strengths, 0.1);
  expect_normal(frequencies, 0.05);
  EXPECT_THROW(disorder_amplitudes(layout, all, 1, 2), InputError);
  disorder_phases(layout, all, std::nullopt, 1);
  std::vector<double> sines;
  for (const Swimmer& swimmer : layout.swimmers) sines.push_back(std::sin(swimmer.driving->phase_offset));
  expect_normal(sines, std::numbers::sqrt2 / 2);
}

// Gaps change one by one, by whole cells, the box by their sum, and nothing else moves.
TEST(Spacing, ChangesTheGapsBetweenLayers) {
  const Layout swarm = large_swarm();
  Layout spaced = swarm;
  space_layers(spaced, {.axis = 1, .sigma = 4, .whole = 2}, 1.0, 6);
  const auto heights = [](const Layout& layout) {
    std::set<double> found;
    for (const Swimmer& swimmer : layout.swimmers) found.insert(swimmer.position[1]);
    return std::vector<double>(found.begin(), found.end());
  };
  const std::vector<double> places = heights(spaced);
  ASSERT_EQ(places.size(), 15);
  double sum = 0;
  std::set<double> changes;
  for (std::size_t n = 0; n < places.size(); ++n) {
    const double gap = places[n] - (n > 0 ? places[n - 1] : places.back() - spaced.domain.box->lengths[1]);
    EXPECT_NEAR(std::remainder(gap - 32, 2), 0, 1e-9);
    changes.insert(gap - 32);
    sum += gap - 32;
  }
  EXPECT_GT(changes.size(), 3);
  EXPECT_NEAR(spaced.domain.box->lengths[1] - swarm.domain.box->lengths[1], sum, 1e-9);
  EXPECT_EQ(spaced.domain.box->lengths[0], swarm.domain.box->lengths[0]);
  for (std::size_t s = 0; s < swarm.swimmers.size(); ++s)
    EXPECT_EQ(spaced.swimmers[s].position[2], swarm.swimmers[s].position[2]);
  Layout one = swarm;
  space_layers(one, {.axis = 2, .sigma = 4}, std::int64_t{1}, 6);
  std::set<double> across_z;
  for (const Swimmer& swimmer : one.swimmers) across_z.insert(swimmer.position[2]);
  int changed = 0;
  double before = *across_z.rbegin() - one.domain.box->lengths[2];
  for (const double place : across_z) {
    changed += std::abs(place - before - 32) > 1e-9 ? 1 : 0;
    before = place;
  }
  EXPECT_EQ(changed, 1);
  EXPECT_THROW(space_layers(one, {.axis = 2, .sigma = 400}, 1.0, 6), InputError);
}

// A layer at the periodic face is one, whichever face its swimmers are at; walls are not spaced.
TEST(Spacing, KeepsALayerAtTheFaceTogether) {
  for (int seed = 1; seed < 6; ++seed) {
    Layout layout = swarm_of(paper_uniform_plan(), paper_swarm().types.at("a"));
    for (Swimmer& swimmer : layout.swimmers) swimmer.position[1] += swimmer.id == 3 ? 80 - 1e-9 : -16;
    space_layers(layout, {.axis = 1, .sigma = 2}, 1.0, seed);
    const double length = layout.domain.box->lengths[1];
    const double apart = layout.swimmers[3].position[1] - layout.swimmers[0].position[1];
    EXPECT_NEAR(std::remainder(apart, length), 0, 1e-8) << seed;
  }
  Layout walled = paper_single();
  space_layers(walled, {.axis = 1, .sigma = 100}, 1.0, 3);
  EXPECT_EQ(walled.domain.box->lengths, paper_single().domain.box->lengths);
}

TEST(Repair, PartsWhatOverlaps) {
  Layout layout = large_swarm();
  jitter(layout, draw_swimmer_indices(layout, 1.0, 3), 8, 3);
  ASSERT_FALSE(check_layout(layout).empty());
  const Layout before = layout;
  repair_overlaps(layout);
  EXPECT_TRUE(check_layout(layout).empty());
  EXPECT_GE(smallest_gap(placed_beads(layout), layout.domain), 0.3);
  std::size_t moved = 0;
  for (std::size_t s = 0; s < layout.swimmers.size(); ++s) {
    moved += layout.swimmers[s].position != before.swimmers[s].position ? 1 : 0;
    EXPECT_EQ(layout.swimmers[s].axis, before.swimmers[s].axis);
  }
  EXPECT_GT(moved, 0);
  EXPECT_LT(moved, layout.swimmers.size() / 2);  // and leaves alone what has room
  // Two in one place, and one through a wall.
  Layout walled = paper_single();
  walled.swimmers.push_back(walled.swimmers.front());
  walled.swimmers.back().id = 1;
  walled.swimmers.front().position[1] = 2;
  repair_overlaps(walled);
  EXPECT_TRUE(check_layout(walled).empty());
  // In a channel of little room, not past the middle and back for ever; and no further than need be.
  Layout channel = paper_single();
  channel.domain.box->lengths[1] = 16;
  channel.swimmers.front().position[1] = 1;
  repair_overlaps(channel);
  EXPECT_NEAR(channel.swimmers.front().position[1], 4.4, 0.21);
}

// The numbers themselves, which layouts that were made from a seed rely on.
TEST(Seeds, MeanWhatTheyMeant) {
  EXPECT_EQ(KeyedRandom(1, 2, 3).bits(), 15925659190040627001u);
  EXPECT_EQ(draw_swimmer_indices(large_swarm(), std::int64_t{3}, 1),
            (std::vector<std::size_t>{101, 736, 1693}));
}

}  // namespace
}  // namespace beadswim
