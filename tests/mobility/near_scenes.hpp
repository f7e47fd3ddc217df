#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <optional>
#include <random>
#include <vector>

#include "beadswim/mobility/mobility.hpp"

namespace beadswim {

using Vectors = std::vector<Vec3>;
using Numbers = std::vector<double>;

constexpr double eta = 1.0 / 3;  // [mass/(length time)]

inline Vectors velocities(const MobilityScene& scene, const Vectors& places, const Vectors& forces) {
  const Communicator world(MPI_COMM_WORLD);
  Mobility mobility(scene, places, world);
  Vectors result(places.size());
  mobility.apply(forces, result);
  return result;
}

/// Returns the first beads of swimmers of three beads.
inline std::vector<int> lines_of_three(const Numbers& radii) {
  std::vector<int> lines;
  for (int b = 0; b + 3 <= std::ssize(radii); b += 3) lines.push_back(b);
  return lines;
}

inline MobilityScene near_scene(const Numbers& radii, const std::optional<Box>& box = {}) {
  return {MobilityModel::rpy_near, eta, {.box = box}, radii, 1e-8, lines_of_three(radii)};
}

/// Returns all columns of the mobility matrix.
inline Eigen::MatrixXd matrix_of(const MobilityScene& scene, const Vectors& places) {
  const Communicator world(MPI_COMM_WORLD);
  Mobility mobility(scene, places, world);
  const auto n = static_cast<Eigen::Index>(3 * places.size());
  Eigen::MatrixXd matrix(n, n);
  for (Eigen::Index c = 0; c < n; ++c) {
    Vectors forces(places.size(), Vec3::Zero()), column(places.size());
    forces[c / 3][c % 3] = 1;
    mobility.apply(forces, column);
    matrix.col(c) = Eigen::Map<const Eigen::VectorXd>(column[0].data(), n);
  }
  return matrix;
}

inline double largest_difference(const Vectors& a, const Vectors& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, (a[k] - b[k]).norm());
  return largest;
}

/// A dense group of straight and bent swimmers with bead radii from 1 to 1.5. Many beads overlap.
struct Crowd {
  Vectors places, forces;
  Numbers radii;

  Crowd(unsigned seed, int swimmers, const Vec3& lengths) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto vector = [&] {
      return Vec3(uniform(random) - 0.5, uniform(random) - 0.5, uniform(random) - 0.5);
    };
    for (int s = 0; s < swimmers; ++s) {
      const Vec3 middle = lengths.cwiseProduct(vector() + Vec3::Constant(0.5)), axis = vector().normalized();
      for (int b = -1; b <= 1; ++b) {
        const Vec3 place = middle + b * (2.8 + uniform(random)) * axis + 0.5 * vector();
        places.push_back(place.cwiseMax(0.2).cwiseMin(lengths.array().matrix() - Vec3::Constant(0.2)));
        radii.push_back(1 + 0.5 * static_cast<double>((s + b + 1) % 2));
        forces.push_back(vector());
      }
    }
    Vec3 sum = Vec3::Zero();
    for (const Vec3& force : forces) sum += force;
    for (Vec3& force : forces) force -= sum / static_cast<double>(forces.size());
  }
};

}  // namespace beadswim
