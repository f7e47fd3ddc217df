#include "ewald_split.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "beadswim/core/gauss_legendre.hpp"
#include "window_table.hpp"

// Splitting of the Oseen tensor and windows of a mesh, each alone. Units: viscosity 1, cutoff 2.

namespace beadswim {
namespace {

constexpr double pi = std::numbers::pi, cutoff = 2;

void expect_tensor(const PairTensor& found, double isotropic, double axial, double allowed) {
  EXPECT_NEAR(found.isotropic, isotropic, allowed);
  EXPECT_NEAR(found.axial, axial, allowed);
}

// Oseen tensor T = (I + rr/r^2)/(8 pi r), its Laplacian (2 I - 6 rr/r^2)/(8 pi r^3), whose Laplacian is 0.
TEST(EwaldSplit, HasPartsWhoseSumIsTheOseenTensor) {
  for (const double shape : {6.0, 20.0}) {
    const EwaldSplit split(cutoff, shape);
    for (const double r : {0.3, 1.0, 1.7, 1.999}) {
      const SplitTensor near = near_tensor(split, r, 1), far = far_tensor(split, r, 1);
      const double oseen = 1 / (8 * pi * r), slope = oseen / (r * r);
      const auto sum = [](const PairTensor& a, const PairTensor& b) {
        return PairTensor{a.isotropic + b.isotropic, a.axial + b.axial};
      };
      expect_tensor(sum(near.oseen, far.oseen), oseen, oseen, 1e-11);
      expect_tensor(sum(near.laplacian, far.laplacian), 2 * slope, -6 * slope, 1e-9 * (1 + slope));
      expect_tensor(sum(near.bilaplacian, far.bilaplacian), 0, 0, 1e-7 * (1 + slope / (r * r)));
    }
    const SplitTensor edge = near_tensor(split, cutoff * (1 - 1e-9), 1);
    expect_tensor(edge.oseen, 0, 0, 10 * shape * std::exp(-shape));
  }
}

// The Laplacian of a trace t(r) is t'' + 2 t'/r, here by differences.
TEST(EwaldSplit, HasTheLaplaciansOfItsParts) {
  const EwaldSplit split(cutoff, 8);
  const auto trace = [](const PairTensor& tensor) { return 3 * tensor.isotropic + tensor.axial; };
  constexpr double d = 1e-3;
  for (const double r : {0.4, 1.0, 1.6}) {
    for (const auto& part : {near_tensor, far_tensor}) {
      const SplitTensor before = part(split, r - d, 1), here = part(split, r, 1),
                        after = part(split, r + d, 1);
      const auto laplacian = [&](PairTensor SplitTensor::*term) {
        const double below = trace(before.*term), above = trace(after.*term);
        return (above - 2 * trace(here.*term) + below) / (d * d) + (above - below) / (r * d);
      };
      EXPECT_NEAR(trace(here.laplacian), laplacian(&SplitTensor::oseen), 1e-4);
      EXPECT_NEAR(trace(here.bilaplacian), laplacian(&SplitTensor::laplacian), 1e-4);
    }
  }
}

// The trace of the far part is the integral of 2 s(k)/k^2 exp(i k.r) over wavevectors.
TEST(EwaldSplit, HasAFarPartWhoseTransformIsItsShare) {
  const EwaldSplit split(cutoff, 20);
  EXPECT_NEAR(split.far_share(0), 1, 1e-12);
  for (const double r : {0.2, 1.0, 1.8}) {
    double trace = 0;
    for (const auto& [k, weight] : gauss_legendre(200, 0, 40))
      trace += weight * split.far_share(k) * std::sin(k * r) / (k * r) / (pi * pi);
    const PairTensor far = far_tensor(split, r, 1).oseen;
    EXPECT_NEAR(3 * far.isotropic + far.axial, trace, 1e-8);
  }
}

// Value and derivatives of I_0(b sqrt(1 - (2 x/P)^2)), and its Fourier transform by quadrature.
TEST(WindowTable, IsTheKaiserBesselFunctionAndItsDerivatives) {
  for (const int points : {5, 8, 12}) {
    const double shape = 1.9 * points, height = 1 / (points * sinh_ratio(shape * shape));
    const WindowTable table(points, shape);
    const auto window = [&](double x) { return height * kaiser_bessel_bell(shape, 2 * x / points); };
    const int padded = (points + 3) / 4 * 4;
    const auto polynomial = [&](int derivative, int point, double place) {
      double value = 0;
      for (int power = table.degree(); power >= 0; --power)
        value =
            value * place + table.polynomials()[(derivative * (table.degree() + 1) + power) * padded + point];
      return value;
    };
    const double edge = window(points / 2.0), largest = window(0);
    constexpr double d = 1e-3;
    for (int point = 0; point < points; ++point) {
      for (const double place : {-0.8, 0.1, 0.7}) {
        const double x = point - points / 2.0 + (place + 1) / 2;
        EXPECT_NEAR(polynomial(0, point, place), window(x), edge);
        EXPECT_NEAR(polynomial(1, point, place), (window(x + d) - window(x - d)) / (2 * d),
                    10 * edge + 1e-5 * largest);
        EXPECT_NEAR(polynomial(2, point, place), (window(x + d) - 2 * window(x) + window(x - d)) / (d * d),
                    100 * edge + 1e-5 * largest);
      }
    }
    for (const double k : {0.0, 1.0, 3.0}) {
      double transform = 0;
      for (const auto& [x, weight] : gauss_legendre(60, 0, points / 2.0))
        transform += 2 * weight * window(x) * std::cos(k * x);
      EXPECT_NEAR(table.transform(k), transform, 1e-12);
    }
  }
}

}  // namespace
}  // namespace beadswim
