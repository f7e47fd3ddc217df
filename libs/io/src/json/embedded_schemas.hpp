#pragma once

#include <map>
#include <string>

namespace beadswim {

/// Returns the texts of the files in the folder schemas/ by name: the file layout.schema.json has the name
/// "layout". The definition is generated (cmake/EmbedSchemas.cmake).
const std::map<std::string, std::string>& embedded_schemas();

}  // namespace beadswim
