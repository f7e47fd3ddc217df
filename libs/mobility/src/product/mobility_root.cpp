#include "beadswim/mobility/mobility_root.hpp"

#include <algorithm>
#include <array>
#include <functional>

#include "beadswim/core/dense_systems.hpp"
#include "beadswim/core/keyed_random.hpp"
#include "beadswim/mobility/mobility_matrix.hpp"
#include "grand_mobility.hpp"

namespace beadswim {
namespace {

/// Returns T^(1/2) e_1 for a symmetric matrix. Negative eigenvalues, which are errors, count as zero.
Eigen::VectorXd first_column_of_root(const SymmetricModes& modes) {
  const Eigen::VectorXd roots = modes.values.cwiseMax(0).cwiseSqrt();
  return modes.vectors * roots.cwiseProduct(modes.vectors.row(0).transpose());
}

struct LanczosRoot {
  Eigen::VectorXd product;
  double error = 0;
  bool is_converged = true;
};

/// Returns the product of the root of a symmetric matrix and z. `apply`: product with the matrix. `scale`:
/// elements of S. The result is equal on all ranks.
LanczosRoot lanczos_root(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& apply,
                         const Eigen::VectorXd& scale, const Eigen::VectorXd& z, double tolerance,
                         const Communicator& communicator) {
  constexpr Eigen::Index max_products = 100, usual_products = 16;
  const Eigen::Index size = z.size(), most = std::min(size, max_products);
  LanczosRoot result;
  Eigen::MatrixXd columns(size, std::min(most, usual_products)), T = Eigen::MatrixXd::Zero(most, most);
  columns.col(0) = z.normalized();
  Eigen::VectorXd root;  // T^(1/2) e_1
  for (Eigen::Index k = 0;; ++k) {
    const auto basis = columns.leftCols(k + 1);
    Eigen::VectorXd next = apply(basis.col(k).cwiseQuotient(scale)).cwiseQuotient(scale);
    T.col(k).head(k + 1) = basis.transpose() * next;
    T.row(k).head(k + 1) = T.col(k).head(k + 1).transpose();
    next.noalias() -= basis * T.col(k).head(k + 1);
    next -= basis * (basis.transpose() * next);  // again, because the first result has roundoff
    const SymmetricModes modes(T.topLeftCorner(k + 1, k + 1));
    const Eigen::VectorXd before = root;
    root = first_column_of_root(modes);
    Eigen::VectorXd change = root;
    change.head(before.size()) -= before;
    constexpr double roundoff = 1e-14;
    const double largest = modes.values.cwiseAbs().maxCoeff();
    std::array<double, 3> decision{change.norm() / root.norm(), next.norm() / largest,
                                   modes.values[0] / largest};
    MPI_Bcast(decision.data(), 3, MPI_DOUBLE, 0, communicator.get());  // all ranks must decide equally
    const auto [error, rest, smallest] = decision;
    result.error = rest > roundoff && k + 1 < size ? error : 0;
    // Products have errors of about the tolerance, by which eigenvalues near zero can become negative.
    const bool is_positive = smallest > -10 * tolerance;
    if (result.error > tolerance && is_positive && k + 1 < most) {
      if (k + 1 == columns.cols())
        columns.conservativeResize(Eigen::NoChange, std::min(most, 2 * columns.cols()));
      columns.col(k + 1) = next.normalized();
      continue;
    }
    result.is_converged = result.error <= tolerance && is_positive;
    break;
  }
  result.product = z.norm() * scale.cwiseProduct(columns.leftCols(root.size()) * root);
  broadcast_doubles(result.product.data(), size, communicator);
  return result;
}

/// Returns `each` normally distributed numbers per sphere.
Eigen::VectorXd normal_numbers(std::uint64_t seed, std::size_t spheres, int each) {
  Eigen::VectorXd numbers(each * static_cast<Eigen::Index>(spheres));
  for (std::size_t b = 0; b < spheres; ++b) {
    KeyedRandom random(seed, b, 0);
    for (int m = 0; m < each; ++m) numbers[each * static_cast<Eigen::Index>(b) + m] = random.normal();
  }
  return numbers;
}

/// Returns the roots of the diagonal of the self-mobilities of all spheres.
Eigen::VectorXd self_scale(const MobilityScene& scene, int order) {
  const int each = moment_count(order);
  Eigen::VectorXd scale(each * std::ssize(scene.radii));
  for (std::size_t b = 0; b < scene.radii.size(); ++b)
    scale.segment(each * static_cast<Eigen::Index>(b), each) =
        moment_self_mobility(order, scene.radii[b], scene.viscosity).diagonal().cwiseSqrt();
  return scale;
}

std::span<const double> numbers_of(const Eigen::VectorXd& vector) {
  return {vector.data(), static_cast<std::size_t>(vector.size())};
}
std::span<double> numbers_of(Eigen::VectorXd& vector) {
  return {vector.data(), static_cast<std::size_t>(vector.size())};
}

Eigen::Map<Eigen::VectorXd> flat(std::vector<Vec3>& vectors) {
  return {vectors[0].data(), 3 * std::ssize(vectors)};
}

}  // namespace

MobilityRoot::MobilityRoot(const MobilityScene& scene, std::span<const Vec3> positions, double tolerance,
                           Mobility& mobility, const Communicator& communicator)
    : scene_(scene), tolerance_(tolerance), mobility_(mobility), communicator_(communicator) {
  if (!scene.domain.box || highest_moment(scene) > 0 || scene.model == MobilityModel::rpy_near) return;
  MobilityScene split = scene;
  split.tolerance = std::min(tolerance, 1e-2);  // the largest of an Ewald sum
  if (const auto plan = root_plan(split, positions, communicator))
    split_ = std::make_unique<GrandMobility>(split, plan, communicator);
}

MobilityRoot::~MobilityRoot() = default;

/// Returns true if a Cholesky decomposition of the mobility takes less time than products with it.
bool MobilityRoot::has_small_matrix() const {
  constexpr std::size_t max_spheres = 24;
  return scene_.radii.size() <= max_spheres && !scene_.domain.box && !scene_.domain.half_space &&
         scene_.model != MobilityModel::oseen && scene_.model != MobilityModel::rpy_near &&
         highest_moment(scene_) == 0;
}

RootProduct MobilityRoot::of_matrix(std::span<const Vec3> positions, std::uint64_t seed) const {
  struct Sphere {
    double radius;
  };
  std::vector<Sphere> spheres;
  for (const double radius : scene_.radii) spheres.push_back({radius});
  const Eigen::Map<const Eigen::Matrix3Xd> centres(positions[0].data(), 3, std::ssize(positions));
  const auto factor = cholesky_factor(
      mobility_matrix<Eigen::MatrixXd>(rotne_prager_tensor, spheres, centres, scene_.viscosity));
  RootProduct result{.velocities = std::vector<Vec3>(positions.size(), Vec3::Zero())};
  result.is_converged = factor.has_value();
  if (factor)
    flat(result.velocities) =
        factor->triangularView<Eigen::Lower>() * normal_numbers(seed, positions.size(), 3);
  broadcast_doubles(result.velocities[0].data(), 3 * std::ssize(result.velocities), communicator_);
  return result;
}

RootProduct MobilityRoot::at(std::span<const Vec3> positions, std::uint64_t seed) {
  const std::size_t spheres = positions.size();
  if (split_) return of_split(positions, seed);
  if (has_small_matrix()) return of_matrix(positions, seed);
  mobility_.set_positions(positions);
  RootProduct result{.velocities = std::vector<Vec3>(spheres, Vec3::Zero())};
  const int order = highest_moment(scene_);
  const auto apply = [&](const Eigen::VectorXd& moments) {
    Eigen::VectorXd projections(moments.size());
    if (order > 0) {
      mobility_.project_flow_of(numbers_of(moments), numbers_of(projections));
      ++result.work.iterations;
      return projections;
    }
    std::vector<Vec3> forces(spheres), velocities(spheres);
    flat(forces) = moments;
    result.work.add(mobility_.apply(forces, velocities));
    return Eigen::VectorXd(flat(velocities));
  };
  const LanczosRoot root =
      lanczos_root(apply, self_scale(scene_, order), normal_numbers(seed, spheres, moment_count(order)),
                   tolerance_, communicator_);
  if (order > 0)
    result.work.add(mobility_.move_in_flow(numbers_of(root.product), result.velocities));
  else
    flat(result.velocities) = root.product;
  result.error = root.error;
  result.is_converged = root.is_converged && result.work.is_converged;
  return result;
}

RootProduct MobilityRoot::of_split(std::span<const Vec3> positions, std::uint64_t seed) {
  split_->set_positions(positions);
  RootProduct result{.velocities = std::vector<Vec3>(positions.size())};
  const auto apply = [&](const Eigen::VectorXd& forces) {
    Eigen::VectorXd velocities(forces.size());
    split_->apply(numbers_of(forces), numbers_of(velocities), FlowPart::near);
    ++result.work.products;
    return velocities;
  };
  const LanczosRoot near = lanczos_root(apply, self_scale(scene_, 0),
                                        normal_numbers(seed, positions.size(), 3), tolerance_, communicator_);
  Eigen::VectorXd far(near.product.size());
  split_->set_far_noise(seed ^ golden_gamma, numbers_of(far));
  flat(result.velocities) = near.product + far;
  result.error = near.error;
  result.is_converged = near.is_converged;
  return result;
}

}  // namespace beadswim
