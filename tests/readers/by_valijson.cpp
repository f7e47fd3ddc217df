// Program that validates documents with the validator of Beadswim (valijson): valid documents, and documents
// with one fault each.
//
// usage: by_valijson DOCUMENTS FAULTS     folders; documents are SCHEMA/NAME.json

#include <cstdio>
#include <filesystem>
#include <string>

#include "beadswim/core/error.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/io/schema.hpp"

namespace {

namespace fs = std::filesystem;

struct Count {
  int documents = 0, wrong = 0;
};

/// Returns the fault of the document; an empty text if it is valid.
std::string fault_of(const fs::path& file, const std::string& schema) {
  try {
    beadswim::validate_json(beadswim::parse_json(beadswim::read_text(file), file), schema, file);
  } catch (const beadswim::InputError& error) {
    return error.what();
  }
  return "";
}

Count check(const fs::path& folder, bool sound) {
  Count count;
  for (const auto& schema : fs::directory_iterator(folder)) {
    for (const auto& file : fs::directory_iterator(schema.path())) {
      const std::string fault = fault_of(file.path(), schema.path().filename());
      ++count.documents;
      if (fault.empty() == sound) continue;
      ++count.wrong;
      std::fprintf(stderr, "%s: %s\n", file.path().c_str(), sound ? fault.c_str() : "is not refused");
    }
  }
  return count;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const Count sound = check(argv[1], true), faulty = check(argv[2], false);
  if (sound.wrong + faulty.wrong > 0 || sound.documents * faulty.documents == 0) return 1;
  std::printf("%d documents accepted, %d faults refused\n", sound.documents, faulty.documents);
}
