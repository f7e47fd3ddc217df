#pragma once

#include "beadswim/core/communicator.hpp"
#include "beadswim/lattice/levels.hpp"

namespace beadswim {

/// Sets all populations of `to` from those of `from`, which covers the same box with other levels. The number
/// of levels must be equal, and all levels of `from` must have reached the same time. Cells of `from` that
/// are not in use are changed. Mass and momentum are conserved to roundoff.
///
/// Cells of a level that existed before keep their populations. Other cells take them from the next finer or
/// coarser level, at the place where both are equal in linear flow (level_interface.hpp). f* is a population
/// after collision and c its velocity:
///
///   finer to coarser   F*(X) = mean of the eight f* in X + (c/2).grad f*     [cell of the finer level]
///   coarser to finer   f*(x) = F*(X) + (s - c/4).grad F*                     [cell of the coarser level]
///
/// s is the centre of x relative to the centre of the coarser cell X. The terms with c must not change mass
/// and momentum of a cell; such changes, which are of second order, are subtracted. Collective.
void transfer(Levels& from, Levels& to, const Communicator& communicator);

}  // namespace beadswim
