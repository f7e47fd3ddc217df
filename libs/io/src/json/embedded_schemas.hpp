#pragma once

#include <string_view>
#include <vector>

namespace beadswim {

/// One file of schemas/: "layout" and the text of schemas/layout.schema.json.
struct EmbeddedSchema {
  std::string_view name;
  std::string_view text;
};

/// Every schema the library was built with, by name. The definition is generated (cmake/EmbedSchemas.cmake).
const std::vector<EmbeddedSchema>& embedded_schemas();

}  // namespace beadswim
