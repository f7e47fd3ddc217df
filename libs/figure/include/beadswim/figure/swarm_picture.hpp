#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/figure/drawing.hpp"

// Perspective picture of a swarm in its box as SVG: x points to the right, y away from the viewer and z up.
// Equal pictures have equal bytes.

namespace beadswim {

struct PicturedBead {
  Vec3 centre = Vec3::Zero();  ///< [length]
  double radius = 0;           ///< [length]
};

struct PicturedSwimmer {
  int id = 0;
  std::vector<PicturedBead> beads;          ///< at least one
  std::vector<std::array<int, 2>> bonds{};  ///< indices of the two beads that each bond joins
  int colour = 0;                           ///< index in the palette of Okabe and Ito, modulo its size
  std::optional<double> value{};            ///< shown by the colour if SwarmPicture::value_label is set
  Vec3 axis = Vec3::Zero();                 ///< unit vector from tail to head; zero: no head is drawn
  std::array<int, 3> layer{};               ///< number of the swimmer's layer along each axis, from 0

  /// Returns the bead with the index n/2 of n beads. It stands for the swimmer's position.
  const PicturedBead& middle_bead() const { return beads[beads.size() / 2]; }
};

/// A text above a bead.
struct PictureMark {
  std::string name;
  PicturedBead bead;
};

/// A labelled double arrow that shows the distance of two beads.
struct PictureDistance {
  std::string label;                            ///< "_" makes the next character a subscript: "D_x = 56"
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< centres of the beads [length]
  Vec3 arrow_offset = Vec3::Zero();             ///< displacement of the arrow from the beads [length]
};

struct SwarmPicture {
  std::string title;
  Vec3 box = Vec3::Zero();  ///< lengths of the box, which starts at the origin; its edges are drawn [length]
  std::vector<PicturedSwimmer> swimmers{};
  std::vector<std::string> keys{};  ///< legend: the meanings of the colours 0, 1, ...
  AxisLabel value_label{};  ///< of the values that colours show, with a bar; empty: colours of the palette
  std::vector<PictureMark> marks{};
  std::vector<PictureDistance> distances{};
  std::vector<Note> notes{};
  std::string
      length_unit{};  ///< for the scale bar along the lower front edge of the box, and for the numbers
  Vec3 origin = Vec3::Zero();  ///< place of the corner of the box in the coordinates of the layout [length]
};

/// Draws the picture, with about 70 bytes per bead: beads are shaded discs, bonds are lines and heads are
/// triangles in front of the swimmer, and near ones hide far ones. Swimmers without value are grey. Its
/// numbers are the beads: id of the swimmer, number of the bead in it, place in the coordinates of the layout
/// and radius, with the unit of length, and the value that the colour shows. Throws InputError if there is no
/// swimmer.
Drawing draw(const SwarmPicture& picture);

/// Moves each swimmer by multiples of the box lengths along periodic axes, so that its middle bead is in the
/// box.
void wrap_swimmers(std::vector<PicturedSwimmer>& swimmers, const Box& box);

/// Displaces all swimmers by the same vector, so that a box around them starts at the origin. Between the
/// beads and the faces of this box there is a margin of one bead radius. Returns the edges of the box
/// [length]. Use this function for swimmers in open space, which have no box.
Vec3 enclose_swimmers(std::vector<PicturedSwimmer>& swimmers);

/// Returns the distances of figure 4 of the paper (Pickl et al. 2017). Each distance is drawn at the outline
/// of the swarm:
///   C  between neighbours in the same block of swimmers
///   D  between neighbours in adjacent blocks
/// Along x, a distance is between the end beads that face each other. Along y and z, it is between those
/// beads of two swimmers that have the largest x. `block_swimmers` is the number of swimmers in a block along
/// each axis. Returns an empty list if no swimmer has a neighbour along any axis.
std::vector<PictureDistance> swarm_distances(const std::vector<PicturedSwimmer>& swimmers,
                                             const std::vector<int>& block_swimmers);

}  // namespace beadswim
