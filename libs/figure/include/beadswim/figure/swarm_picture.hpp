#pragma once

#include <array>
#include <string>
#include <vector>

#include "beadswim/core/vec3.hpp"

// A swarm in its box as SVG, seen in perspective: x to the right, y away, z up. The same picture gives the
// same bytes.

namespace beadswim {

struct PicturedSwimmer {
  std::array<Vec3, 3> beads;      ///< centres [length]
  std::array<double, 3> radii{};  ///< [length]
  int colour = 0;                 ///< position in the palette of Okabe and Ito; wraps round
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

}  // namespace beadswim
