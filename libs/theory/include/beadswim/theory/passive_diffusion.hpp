#pragma once

#include "beadswim/core/fields.hpp"
#include "beadswim/scene/layout.hpp"
#include "beadswim/theory/stroke.hpp"

// Diffusion of a swimmer by thermal noise, by the Rotne-Prager mobility mu of its beads in open space. A
// rigid motion (v, Omega) of the beads, dx_i/dt = v + Omega x (x_i - x_m) = (K (v, Omega))_i about their mean
// place x_m, has the mobility (K^T mu^-1 K)^-1 = N:
//
//   D_0 = kT tr(N_vv)/3,   D_r = kT tr(N_OmegaOmega across the axis)/2
//   D   = D_0 + v^2/(6 D_r)                                   of a swimmer of mean speed v along its axis
//   <|dR|^2> = 6 D_0 t + v^2/(2 D_r^2) [2 D_r t - 1 + exp(-2 D_r t)],   <e(0).e(t)> = exp(-2 D_r t)
//
//   dR  displacement in the time t;  e  axis of the swimmer
//
// D_0 and D_r are means over the stroke, if it is known. The Peclet number is v L/D_0 with the length L and
// D_0 of the swimmer at rest. Reference: Howse et al., Phys. Rev. Lett. 99, 048102 (2007), there in two
// dimensions. Page: docs/method/thermal-noise.md.

namespace beadswim {

struct PassiveDiffusion {
  double translation = 0;  ///< D_0 [length^2/time]
  double rotation = 0;     ///< D_r of the axis [1/time]; 0 for one bead, whose axis noise does not turn
};

/// Returns the diffusion of a swimmer at rest.
PassiveDiffusion passive_diffusion(const SwimmerType& type, const Fluid& fluid);
/// Returns v L/D_0 for the speed v [length/time].
double peclet_number(const SwimmerType& type, const Fluid& fluid, double speed);

/// Diffusion of a swimmer that moves along its axis.
struct ThermalPrediction {
  double passive_diffusion = 0;     ///< D_0 [length^2/time]
  double rotational_diffusion = 0;  ///< D_r [1/time]
  double effective_diffusion = 0;   ///< D [length^2/time]
  double peclet = 0;                ///< v L/D_0 [1]

  BEADSWIM_FIELDS(passive_diffusion, rotational_diffusion, effective_diffusion, peclet)
};

/// Returns the diffusion of a swimmer of the mean speed [length/time] along its axis. Without rotation of the
/// axis, effective_diffusion is D_0. `stroke`, `arm_means`: of a chain of beads on a line, whose arms link
/// consecutive beads; other swimmers count as at rest.
ThermalPrediction predicted_diffusion(const SwimmerType& type, const Fluid& fluid, double speed,
                                      const Stroke& stroke = {}, const std::vector<double>& arm_means = {});

/// Return the mean square displacement in the time t [length^2], and the mean cosine of the angle by which the
/// axis turns.
double mean_square_displacement(const ThermalPrediction& diffusion, double speed, double t);
double mean_cosine(const ThermalPrediction& diffusion, double t);

}  // namespace beadswim
