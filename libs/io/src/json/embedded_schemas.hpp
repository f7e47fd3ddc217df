#pragma once

#include <string_view>
#include <vector>

namespace beadswim {

/// Name and text of a file in the folder schemas/. The file layout.schema.json has the name "layout".
struct EmbeddedSchema {
  std::string_view name;
  std::string_view text;
};

/// Returns all embedded schemas. The definition is generated (cmake/EmbedSchemas.cmake).
const std::vector<EmbeddedSchema>& embedded_schemas();

}  // namespace beadswim
