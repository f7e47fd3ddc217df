#include "unresolved_memory.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "beadswim/core/gauss_legendre.hpp"
#include "beadswim/mobility/force_moments.hpp"

namespace beadswim {
namespace {

/// Smallest rate of the mode times the time step. With slower decay, the flow between close beads at
/// wavenumbers above the cutoff, which has no memory, could exceed that of each bead at itself.
constexpr double min_decay = 1;

/// Returns the mean of 1/k^2 with the weight j_0(k)^2, over the wavenumbers k above the cutoff.
double mean_square_wavelength(double cutoff) {
  double size = std::numbers::pi / 2, delay = 1 / cutoff - std::numbers::pi / 3;  // of j_0^2, of j_0^2/k^2
  const int panels = static_cast<int>(std::ceil(cutoff));
  for (int p = 0; p < panels; ++p) {
    for (const auto& [k, weight] : gauss_legendre(10, cutoff * p / panels, cutoff * (p + 1) / panels)) {
      const double j = std::sin(k) / k;
      size -= weight * j * j;
      delay += weight * (1 - j) * (1 + j) / (k * k);
    }
  }
  return delay / size;
}

}  // namespace

UnresolvedMemory::UnresolvedMemory(std::span<const double> radii, int order, double viscosity,
                                   const FluidMemory& fluid, double cutoff)
    : count_(moment_count(order)), remaining_flow_(count_ * radii.size(), 0.0) {
  std::map<double, std::shared_ptr<const Sphere>> by_radius;
  for (const double a : radii) {
    std::shared_ptr<const Sphere>& sphere = by_radius[a];
    if (!sphere) {
      const double rate = viscosity / fluid.density / (mean_square_wavelength(cutoff * a) * a * a);
      const StepFactors step = step_factors(std::max(rate * fluid.step, min_decay));
      const Eigen::MatrixXd steady =
          moment_self_mobility(order, a, viscosity) - moment_self_mobility_below(cutoff, order, a, viscosity);
      Eigen::VectorXd in_step = Eigen::VectorXd::Ones(steady.rows());
      in_step.head<3>().setConstant(std::sqrt(1 - step.delay));
      sphere = std::make_shared<Sphere>(Sphere{
          .delayed_mobility = steady - in_step.asDiagonal() * steady * in_step.asDiagonal(), .step = step});
    }
    spheres_.push_back(sphere);
  }
}

void UnresolvedMemory::add_projections(std::span<const double> moments, FlowPart part,
                                       std::span<double> projections) const {
  const auto count = static_cast<Eigen::Index>(count_);
  for (std::size_t b = 0; b < spheres_.size(); ++b) {
    const Eigen::Map<const Eigen::VectorXd> of_sphere(&moments[count_ * b], count);
    Eigen::Map<Eigen::VectorXd> onto(&projections[count_ * b], count);
    onto -= spheres_[b]->delayed_mobility * of_sphere;
    if (part == FlowPart::all) onto += Eigen::Map<const Eigen::VectorXd>(&remaining_flow_[count_ * b], count);
  }
}

template <class Share, class Factor>
void UnresolvedMemory::update(const Share& share, const Factor& factor, std::span<const double> moments) {
  const auto count = static_cast<Eigen::Index>(count_);
  for (std::size_t b = 0; b < spheres_.size(); ++b) {
    const auto& [delayed_mobility, step] = *spheres_[b];
    Eigen::Map<Eigen::VectorXd> left(&remaining_flow_[count_ * b], count);
    left = share(step) * left +
           factor(step) * (delayed_mobility * Eigen::Map<const Eigen::VectorXd>(&moments[count_ * b], count));
  }
}

void UnresolvedMemory::start(std::span<const double> moments) {
  update([](const StepFactors&) { return 0.0; },
         [](const StepFactors& step) { return 1 - step.decay / step.delay; }, moments);
}

void UnresolvedMemory::end_step(std::span<const double> moments) {
  update([](const StepFactors& step) { return step.decay; },
         [](const StepFactors& step) { return 1 - step.decay; }, moments);
}

}  // namespace beadswim
