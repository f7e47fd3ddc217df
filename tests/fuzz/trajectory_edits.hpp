#pragma once

#include <string>

#include "byte_source.hpp"

namespace beadswim {

/// Writes a small trajectory, with the edits that the bytes say: datasets of other types, shapes and values,
/// with less or more dimensions, without storage, missing, or something else. No bytes: a sound one.
void write_edited_trajectory(const std::string& path, ByteSource& edits);

}  // namespace beadswim
