#pragma once

#include <vector>

#include "beadswim/layout/layout.hpp"
#include "beadswim/theory/question.hpp"

namespace beadswim {

/// A swimmer that stands for those like it, as theory is asked about it.
struct Representative {
  int swimmer = 0;  ///< its id
  Question question;
  /// False: it is asked about as one swimmer in its share of the box, along its own line, while its
  /// neighbours differ, it lies aslant, or its walls are not of those that theory knows.
  bool is_exact = true;
};

/// One of each type, by the first swimmer of it; `cell`: a scene's smallest cell. Throws InputError where a
/// swimmer is none to theory, without springs for one.
std::vector<Representative> representatives(const Layout& cell);

}  // namespace beadswim
