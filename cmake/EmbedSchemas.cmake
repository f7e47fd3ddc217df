# Writes the C++ file OUTPUT, which contains the text of each file *.schema.json in FOLDER: the table that embedded_schemas.hpp
# declares.
file(GLOB schemas ${FOLDER}/*.schema.json)
list(SORT schemas)
set(entries "")
foreach(schema ${schemas})
  get_filename_component(name ${schema} NAME)
  string(REPLACE ".schema.json" "" name ${name})
  file(READ ${schema} text)
  string(APPEND entries "    {\"${name}\", R\"schema(${text})schema\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"embedded_schemas.hpp\"

namespace beadswim {

const std::map<std::string, std::string>& embedded_schemas() {
  static const std::map<std::string, std::string> table{
${entries}  };
  return table;
}

}  // namespace beadswim
")
