#include "lowest_mobility.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "bead_vectors.hpp"
#include "beadswim/core/keyed_random.hpp"
#include "beadswim/mobility/pair_mobility.hpp"

namespace beadswim {

LowestMobility::LowestMobility(const OverdampedScene& scene, const MobilityProduct& mobility,
                               std::span<const double> radii, const Communicator& communicator)
    : mobility_(mobility),
      communicator_(communicator),
      root_drag_(3 * radii.size()),
      mode_(3 * radii.size()) {
  KeyedRandom random(1, 0, 0);
  for (std::size_t b = 0; b < radii.size(); ++b) {
    root_drag_.segment<3>(3 * b).setConstant(std::sqrt(1 / self_mobility(radii[b], scene.viscosity)));
    mode_.segment<3>(3 * b) = random.normal3();
  }
}

Eigen::VectorXd LowestMobility::product(std::span<const Vec3> positions, const Eigen::VectorXd& mode) const {
  Beads forces(positions.size()), velocities(positions.size());
  flat(forces) = root_drag_.cwiseProduct(mode);
  mobility_.apply(positions, forces, velocities);
  return root_drag_.cwiseProduct(flat(velocities));
}

std::optional<std::size_t> LowestMobility::reversed_bead(std::span<const Vec3> positions) {
  constexpr int max_products = 60;
  constexpr double converged = 0.02;  // residual, divided by the eigenvalue
  const Eigen::Index most = std::min<Eigen::Index>(max_products, mode_.size());
  Eigen::MatrixXd basis = mode_.normalized(), projected = Eigen::MatrixXd::Zero(most, most);
  std::array<double, 2> ritz{};  // eigenvalue and its residual
  for (Eigen::Index k = 0;; ++k) {
    Eigen::VectorXd next = product(positions, basis.col(k));
    projected.col(k).head(k + 1) = basis.transpose() * next;
    for (int pass = 0; pass < 2; ++pass) next -= basis * (basis.transpose() * next);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> small(
        projected.topLeftCorner(k + 1, k + 1).selfadjointView<Eigen::Upper>());
    mode_ = basis * small.eigenvectors().col(0);
    ritz = {small.eigenvalues()[0], next.norm() * std::abs(small.eigenvectors()(k, 0))};
    MPI_Bcast(ritz.data(), 2, MPI_DOUBLE, 0, communicator_.get());  // all ranks must make the same decision
    if (!(ritz[0] > 0 && ritz[1] > converged * ritz[0]) || k + 1 == most) break;
    basis.conservativeResize(Eigen::NoChange, k + 2);
    basis.col(k + 1) = next.normalized();
  }
  if (ritz[0] > 0) return std::nullopt;
  Eigen::Index component = 0;
  mode_.cwiseAbs().maxCoeff(&component);
  return component / 3;
}

}  // namespace beadswim
