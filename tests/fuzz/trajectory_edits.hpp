#pragma once

#include <string>

#include "byte_source.hpp"

namespace beadswim {

/// Writes a small trajectory with errors that the bytes select: datasets with other types, shapes or values,
/// with fewer or more dimensions, without storage, missing, or replaced by other objects. Without bytes,
/// writes a valid trajectory.
void write_edited_trajectory(const std::string& path, ByteSource& edits);

}  // namespace beadswim
