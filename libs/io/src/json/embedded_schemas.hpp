#pragma once

#include <string_view>
#include <vector>

namespace beadswim {

/// A file of schemas/: for example the name "layout" and the text of schemas/layout.schema.json.
struct EmbeddedSchema {
  std::string_view name;
  std::string_view text;
};

/// Returns all embedded schemas. The definition is generated (cmake/EmbedSchemas.cmake).
const std::vector<EmbeddedSchema>& embedded_schemas();

}  // namespace beadswim
