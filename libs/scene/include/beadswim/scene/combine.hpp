#pragma once

#include <span>
#include <string>

#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// A layout of a combined scene, and the motion of its swimmers into this scene: a turn about the mean of
/// their positions, then a displacement.
struct ScenePart {
  Layout layout;
  std::string source;                ///< name of the layout in messages
  Vec3 displacement = Vec3::Zero();  ///< [length]
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
};

/// Returns the first of the names "b", "c", ..., "z", "a1", "a2", ... that no swimmer type of the layout has.
std::string free_type_name(const Layout& layout);

/// Throws InputError, with the place `source`, if the two layouts have units of different size.
void require_same_units(const Layout& layout, const Layout& other, const std::string& source);

/// Turns a swimmer about the origin of its type's frame. The directions of its forces turn with it only in
/// the frames initial-axis and body.
void turn_swimmer(Swimmer& swimmer, const SwimmerType& type, const Eigen::Quaterniond& turn);

/// Returns one scene with the swimmers of all parts, of which there is at least one. Ids count from 0 in the
/// order of the parts. A type whose name belongs to another type of an earlier part gets a free name. The
/// resolution is kept if all parts have the same. Throws InputError if units, fluids, domains or flows
/// differ.
Layout combine(std::span<const ScenePart> parts);

}  // namespace beadswim
