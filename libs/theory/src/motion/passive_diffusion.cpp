#include "beadswim/theory/passive_diffusion.hpp"

#include <cmath>

#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/core/dense_systems.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"
#include "beadswim/theory/shaped_swimmer.hpp"
#include "shape_flow.hpp"

namespace beadswim {

PassiveDiffusion passive_diffusion(const SwimmerType& type, const Fluid& fluid) {
  const ShapedSwimmer swimmer{type, Eigen::Matrix3d::Identity(), fluid.dynamic_viscosity()};
  const BeadVectors beads =
      centred(columns_of_beads(rest_positions(type, Vec3::Zero(), swimmer.orientation)));
  const std::vector<Vec3> axes = rotation_axes(beads);
  const Eigen::MatrixXd K = rigid_motions(beads, axes),
                        mu = pair_mobility(swimmer, rotne_prager_tensor).matrix(beads);
  const Eigen::MatrixXd resistance = K.transpose() * solve(mu, K), N = inverse(resistance);
  Eigen::Matrix3Xd turns(3, std::ssize(axes));
  for (std::size_t r = 0; r < axes.size(); ++r) turns.col(static_cast<Eigen::Index>(r)) = axes[r];
  const Eigen::Matrix3d rotation =
      turns * N.bottomRightCorner(turns.cols(), turns.cols()) * turns.transpose();
  return {.translation = fluid.thermal_energy * N.topLeftCorner<3, 3>().trace() / 3,
          .rotation = fluid.thermal_energy * (rotation(1, 1) + rotation(2, 2)) / 2};
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
