#pragma once

#include <string>

// A file is PATH.part until it is whole.

namespace beadswim {

std::string part_name(const std::string& path);

/// Puts PATH.part on the disk and gives it its name, in place of an older one. The system's reason if that
/// fails, else 0.
int name_finished_file(const std::string& path);

}  // namespace beadswim
