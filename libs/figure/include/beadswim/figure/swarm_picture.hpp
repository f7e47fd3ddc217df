#pragma once

#include <array>
#include <string>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/vec3.hpp"

// A swarm in its box as SVG, seen in perspective: x to the right, y away, z up. The same picture gives the
// same bytes.

namespace beadswim {

struct PicturedSwimmer {
  std::array<Vec3, 3> beads;      ///< centres [length]
  std::array<double, 3> radii{};  ///< [length]
  int colour = 0;                 ///< position in the palette of Okabe and Ito; wraps round
  std::array<int, 3> layer{};     ///< number of the layer in which it stands, along each axis
};

/// Key to a colour.
struct PictureKey {
  std::string label;
  int colour = 0;
};

/// A name at a bead.
struct PictureMark {
  std::string name;
  Vec3 bead = Vec3::Zero();  ///< centre [length]
  double radius = 0;         ///< [length]
};

/// A labelled double arrow beside two beads.
struct PictureDistance {
  std::string label;                            ///< "_" puts the next character below the line: "D_x = 56"
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< centres of the beads [length]
  Vec3 aside = Vec3::Zero();                    ///< from there to the arrow [length]
};

struct SwarmPicture {
  std::string title;
  Vec3 box = Vec3::Zero();  ///< its edges are drawn, from the origin [length]
  std::vector<PicturedSwimmer> swimmers{};
  std::vector<PictureKey> keys{};
  std::vector<PictureMark> marks{};
  std::vector<PictureDistance> distances{};
  std::vector<std::string> notes{};
};

/// A whole SVG document: beads as shaded discs and arms as lines, the far ones behind the near; some 70 bytes
/// a bead. Throws InputError if there is no swimmer.
std::string swarm_picture_to_svg(const SwarmPicture& picture);

/// Moves each swimmer by multiples of the box so that its middle bead is in the box.
void wrap_swimmers(std::vector<PicturedSwimmer>& swimmers, const Box& box);

/// Moves swimmers in open space into a box around them that begins at the origin. Returns the box's lengths.
Vec3 enclose_swimmers(std::vector<PicturedSwimmer>& swimmers);

/// The distances of the paper's figure 4, each drawn once at the swarm's outline: C from a swimmer to the
/// next of its block, D to that of the next block; across y and z between the beads furthest along x, along x
/// between the end beads that face each other. `block_swimmers` are the swimmers of a block along each axis.
/// Empty if no swimmer has a neighbour along an axis.
std::vector<PictureDistance> swarm_distances(const std::vector<PicturedSwimmer>& swimmers,
                                             const std::vector<int>& block_swimmers);

}  // namespace beadswim
