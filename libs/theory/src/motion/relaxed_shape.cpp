#include "beadswim/swimmers/swimmer_shape.hpp"

#include "beadswim/core/error.hpp"
#include "beadswim/theory/shaped_swimmer.hpp"
#include "shape_flow.hpp"

namespace beadswim {

BeadVectors relaxed_shape(const ShapedSwimmer& swimmer) {
  const RelaxedShape shape = relaxed_shape(swimmer.type);
  if (!shape.is_converged)
    throw InputError("the swimmer's shape at rest",
                     "the springs find no shape in which they exert no forces; give bonds and "
                     "angles rest lengths and rest angles that fit together");
  return swimmer.orientation * centred(shape.beads);
}

}  // namespace beadswim
