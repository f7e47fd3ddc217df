#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "beadswim/core/vec3.hpp"

// clang-format off
// Memory of a fluid with inertia: flow u of forces f on the fluid, at low Reynolds numbers.
//
//   rho du/dt = -grad p + eta laplacian u + f,   div u = 0
//
// Each Fourier mode is the sum of the steady flow u_s of the present forces and a remainder w:
//
//   u = u_s + w,   u_s = (I - kk/k^2) f/(eta k^2),   dw/dt = -nu k^2 w - du_s/dt
//
// If u_s changes linearly in time during a step h, its end (marked +) is exactly
//
//   u+ = g + (1 - phi) u_s+,   E = exp(-nu k^2 h),   phi = (1 - E)/(nu k^2 h)
//   g  = E w + phi u_s,        and for the next step g+ = E g + phi (1 - E) u_s+
//
// g is the flow that earlier forces leave at the end of the step. The mobility in a step is that of steady
// flow, minus phi u_s+. The fluid begins at rest: w = -u_s.
//
// The Reynolds stress is a further force density, of the flow at the end of each step (marked n):
//
//   R = -rho u.grad u = -rho (curl u) x u + a gradient
//   g receives h/rho [ phi R_n + (1 - phi)/(nu k^2 h) (R_n - R_n-1) ]
//
//   rho density [mass/length^3], eta dynamic viscosity, nu = eta/rho;  k wavevector [1/length]
//
// The fluid fills the insides of the spheres too. For spheres, u_s contains their form factors
// (force_moments.hpp). Page: docs/method/fluid-memory.md.
// clang-format on

namespace beadswim {

struct FluidMemory {
  double density = 0;               ///< rho [mass/length^3]; 0: steady flow
  double step = 0;                  ///< h, time step [time]
  double spacing = 0;               ///< largest spacing of the mesh of the Reynolds stress [length]
  bool has_reynolds_stress = true;  ///< true: R acts on the fluid
};

/// Returns the largest wavenumber of the memory in a periodic box with edges of these lengths: two thirds of
/// the largest wavenumber on the mesh of the Reynolds stress, so that products of two flows have no aliases.
double memory_cutoff(const FluidMemory& fluid, const Vec3& lengths);

/// Largest mesh spacing, divided by the smallest bead radius, for each highest moment of the forces (0, 1,
/// 2). Errors of the mesh are larger in swarms than for one bead, because modes above its cutoff add up. The
/// spacing keeps them small compared with errors by missing moments (docs/method/fluid-memory.md).
inline constexpr std::array max_memory_spacing{1.08, 0.85, 0.85};

/// Returns the memory of a fluid of finite density; nullopt for steady flow.
inline std::optional<FluidMemory> inertial_memory(const std::optional<FluidMemory>& memory) {
  return memory && memory->density > 0 ? memory : std::nullopt;
}

/// Flow that a product evaluates.
enum class FlowPart {
  near,    ///< of the given forces, without the far part of an Ewald sum
  forces,  ///< of the given forces; linear in them
  all,     ///< with the background flow, and the flow that earlier forces have left in a fluid with memory
};

/// Largest number of radii whose form factors a mesh with memory treats without interpolation.
constexpr std::size_t max_exact_radii = 4;

/// Factors of a mode in a step, as functions of z = nu k^2 h.
struct StepFactors {
  double decay;  ///< E = exp(-z)
  double delay;  ///< phi = (1 - E)/z
  double ramp;   ///< (1 - phi)/z
};
StepFactors step_factors(double z);

}  // namespace beadswim
