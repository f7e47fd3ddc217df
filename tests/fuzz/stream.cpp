#include "accepted.hpp"
#include "beadswim/io/document_stream.hpp"
#include "memory_file.hpp"

// Fuzz target: a stream of two equal files, as every program reads streams.

using namespace beadswim;

namespace {

std::vector<StreamMember> all_members(DocumentStream& stream) {
  std::vector<StreamMember> members;
  while (std::optional<StreamMember> member = stream.next()) members.push_back(std::move(*member));
  return members;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const MemoryFile file(data, size);
  accepts([&] {
    DocumentStream stream({file.path(), file.path()});
    const std::vector<StreamMember> members = all_members(stream);
    require(!members.empty() && members.size() % 2 == 0, "equal files have equal numbers of documents");
    for (std::size_t i = 0; i < members.size(); ++i)
      require(members[i].number == static_cast<int>(i) + 1, "documents are numbered from 1");
    for (std::size_t i = 0; i < members.size() / 2; ++i)
      require(members[i].text == members[members.size() / 2 + i].text, "equal files have equal documents");
    stream.rewind();
    const std::vector<StreamMember> again = all_members(stream);
    require(again.size() == members.size(), "a stream can be read again");
    for (std::size_t i = 0; i < members.size(); ++i)
      require(again[i].text == members[i].text && again[i].source == members[i].source,
              "a stream that is read again has the same documents");
  });
  return 0;
}
