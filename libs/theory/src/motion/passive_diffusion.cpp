#include "beadswim/theory/passive_diffusion.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <cmath>

#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"
#include "beadswim/theory/shaped_swimmer.hpp"

namespace beadswim {

PassiveDiffusion passive_diffusion(const SwimmerType& type, const Fluid& fluid) {
  const ShapedSwimmer swimmer{type, Eigen::Matrix3d::Identity(), fluid.dynamic_viscosity()};
  BeadVectors beads = columns_of_beads(rest_positions(type, Vec3::Zero(), swimmer.orientation));
  beads.colwise() -= Vec3(beads.rowwise().mean());
  Eigen::MatrixXd K(beads.size(), 6);
  for (Eigen::Index b = 0; b < beads.cols(); ++b) {
    K.block<3, 3>(3 * b, 0).setIdentity();
    for (int a = 0; a < 3; ++a) K.block<3, 1>(3 * b, 3 + a) = Vec3::Unit(a).cross(beads.col(b));
  }
  const Eigen::MatrixXd mu = pair_mobility(swimmer, rotne_prager_tensor).matrix(beads);
  // Beads on a line do not resist rotation about it, which the pseudoinverse leaves out.
  const Eigen::MatrixXd resistance = K.transpose() * mu.llt().solve(K);
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(1e-10);
  const Eigen::MatrixXd N = decomposition.compute(resistance).pseudoInverse();
  return {.translation = fluid.thermal_energy * N.topLeftCorner<3, 3>().trace() / 3,
          .rotation = fluid.thermal_energy * (N(4, 4) + N(5, 5)) / 2};
}

ThermalPrediction predicted_diffusion(const SwimmerType& type, const Fluid& fluid, double speed) {
  const auto [translation, rotation] = passive_diffusion(type, fluid);
  return {.passive_diffusion = translation,
          .rotational_diffusion = rotation,
          .effective_diffusion = translation + (rotation > 0 ? speed * speed / (6 * rotation) : 0),
          .peclet = speed * reach_of_surfaces(type, 0).length() / translation};
}

double mean_square_displacement(const ThermalPrediction& diffusion, double speed, double t) {
  const double x = 2 * diffusion.rotational_diffusion * t;
  const double ballistic = x > 0 ? 2 * (x + std::expm1(-x)) / (x * x) : 1;  // 1 for x -> 0
  return 6 * diffusion.passive_diffusion * t + speed * speed * t * t * ballistic;
}

double mean_cosine(const ThermalPrediction& diffusion, double t) {
  return std::exp(-2 * diffusion.rotational_diffusion * t);
}

}  // namespace beadswim
