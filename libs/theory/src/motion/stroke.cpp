#include "beadswim/theory/stroke.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace beadswim {

namespace {

double phase_of(const std::complex<double>& x) {
  if (std::abs(x) == 0) return 0;  // std::arg(-0.0) is pi
  const double phase = std::arg(x);
  return phase > -std::numbers::pi ? phase : std::numbers::pi;  // std::arg may return -pi
}

}  // namespace

double Stroke::sin_phase_shift() const {
  const bool both_move = amplitude.size() > 1 && amplitude[0] > 0 && amplitude[1] > 0;
  return both_move ? std::sin(phase[0] - phase[1]) : 0;
}

double Stroke::area() const {
  return amplitude[0] * amplitude[1] * sin_phase_shift();
}

Stroke stroke_of(const Eigen::VectorXcd& complex_amplitude) {
  Stroke stroke{.amplitude = {}, .phase = {}};
  for (const std::complex<double>& x : complex_amplitude) {
    stroke.amplitude.push_back(std::abs(x));
    stroke.phase.push_back(phase_of(x));
  }
  return stroke;
}

}  // namespace beadswim
