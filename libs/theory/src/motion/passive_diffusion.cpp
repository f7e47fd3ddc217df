#include "beadswim/theory/passive_diffusion.hpp"

#include <array>
#include <cmath>
#include <numbers>

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

double peclet_number(const SwimmerType& type, const Fluid& fluid, double speed) {
  return speed * reach_of_surfaces(type, 0).length() / passive_diffusion(type, fluid).translation;
}

namespace {

/// Returns true if bond k of the swimmer links beads k and k + 1 of a line.
bool is_chain(const SwimmerType& type) {
  if (!is_straight(type) || type.bonds.size() + 1 != type.beads.size()) return false;
  for (int k = 0; k < std::ssize(type.bonds); ++k)
    if (type.bonds[k].beads != std::array{k, k + 1}) return false;
  return true;
}

/// Returns a chain with arms of these lengths.
SwimmerType with_arms(SwimmerType chain, const std::vector<double>& lengths) {
  const std::vector<BeadAtRest> rest = chain.beads;
  for (std::size_t k = 0; k < lengths.size(); ++k)
    chain.beads[k + 1].at = chain.beads[k].at + lengths[k] * (rest[k + 1].at - rest[k].at).normalized();
  return chain;
}

/// Returns the mean of the diffusion over a stroke.
PassiveDiffusion diffusion_in_stroke(const SwimmerType& type, const Fluid& fluid, const Stroke& stroke,
                                     const std::vector<double>& arm_means) {
  const std::size_t arms = type.bonds.size();
  if (!is_chain(type) || stroke.amplitude.size() != arms) return passive_diffusion(type, fluid);
  constexpr int times = 16;
  PassiveDiffusion mean;
  for (int t = 0; t < times; ++t) {
    std::vector<double> lengths;
    for (std::size_t k = 0; k < arms; ++k)
      lengths.push_back((arm_means.size() == arms ? arm_means[k] : type.bonds[k].rest_length) +
                        stroke.amplitude[k] * std::cos(2 * std::numbers::pi * t / times + stroke.phase[k]));
    const PassiveDiffusion present = passive_diffusion(with_arms(type, lengths), fluid);
    mean.translation += present.translation / times;
    mean.rotation += present.rotation / times;
  }
  return mean;
}

}  // namespace

ThermalPrediction predicted_diffusion(const SwimmerType& type, const Fluid& fluid, double speed,
                                      const Stroke& stroke, const std::vector<double>& arm_means) {
  const auto [translation, rotation] = diffusion_in_stroke(type, fluid, stroke, arm_means);
  return {.passive_diffusion = translation,
          .rotational_diffusion = rotation,
          .effective_diffusion = translation + (rotation > 0 ? speed * speed / (6 * rotation) : 0),
          .peclet = peclet_number(type, fluid, speed)};
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
