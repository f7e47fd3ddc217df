#include "lowest_mobility.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bead_vectors.hpp"
#include "beadswim/core/cell_list.hpp"
#include "beadswim/core/dense_systems.hpp"

namespace beadswim {

bool has_close_spheres(std::span<const Vec3> positions, std::span<const double> radii, const Domain& domain) {
  constexpr double near = 2;  // distance of centres, divided by the sum of the radii; height, by the radius
  bool is_close = false;
  for (std::size_t b = 0; b < positions.size() && domain.half_space; ++b)
    is_close = is_close || domain.half_space->height(positions[b]) < near * radii[b];
  visit_close_pairs(positions, 2 * near * std::ranges::max(radii), domain.box,
                    [&](int i, int j, const Vec3& d) {
                      is_close = is_close || d.norm() < near * (radii[i] + radii[j]);
                      return !is_close;
                    });
  return is_close;
}

std::optional<std::size_t> find_reversed_bead(Mobility& mobility, std::span<const Vec3> positions,
                                              const Eigen::VectorXd& root_mobility, Beads& mode,
                                              const Communicator& communicator) {
  constexpr int max_products = 60;
  constexpr double converged = 0.02;  // residual, divided by the eigenvalue
  const Eigen::Index most = std::min<Eigen::Index>(max_products, 3 * std::ssize(mode));
  mobility.set_positions(positions);
  Eigen::MatrixXd basis = flat(mode).normalized(), projected = Eigen::MatrixXd::Zero(most, most);
  std::array<double, 2> ritz{};  // eigenvalue and its residual
  for (Eigen::Index k = 0;; ++k) {
    Beads forces(positions.size()), velocities(positions.size());
    flat(forces) = basis.col(k).cwiseQuotient(root_mobility);
    mobility.apply(forces, velocities);
    Eigen::VectorXd next = flat(velocities).cwiseQuotient(root_mobility);
    projected.col(k).head(k + 1) = basis.transpose() * next;
    for (int pass = 0; pass < 2; ++pass) next -= basis * (basis.transpose() * next);
    const SymmetricModes small(projected.topLeftCorner(k + 1, k + 1).transpose());
    flat(mode) = basis * small.vectors.col(0);
    ritz = {small.values[0], next.norm() * std::abs(small.vectors(k, 0))};
    MPI_Bcast(ritz.data(), 2, MPI_DOUBLE, 0, communicator.get());  // all ranks must make the same decision
    if (!(ritz[0] > 0 && ritz[1] > converged * ritz[0]) || k + 1 == most) break;
    basis.conservativeResize(Eigen::NoChange, k + 2);
    basis.col(k + 1) = next.normalized();
  }
  if (ritz[0] > 0) return std::nullopt;
  Eigen::Index component = 0;
  flat(mode).cwiseAbs().maxCoeff(&component);
  return component / 3;
}

}  // namespace beadswim
