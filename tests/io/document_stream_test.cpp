#include "beadswim/io/document_stream.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

class DocumentStreams : public testing::Test {
 protected:
  DocumentStreams() { std::filesystem::create_directory(folder_); }
  ~DocumentStreams() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << text;
    return path(name);
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("document-stream-" + std::to_string(::getpid()));
};

std::vector<StreamMember> rest_of(DocumentStream& stream) {
  std::vector<StreamMember> members;
  while (auto member = stream.next()) members.push_back(*member);
  return members;
}

TEST_F(DocumentStreams, ReadOneDocumentOfSeveralLines) {
  const std::string text = "{\n  \"a\": [\n    1,\n    2\n  ]\n}\n", name = file("one.json", text);
  DocumentStream stream({name});
  EXPECT_TRUE(stream.is_single());
  EXPECT_FALSE(stream.is_lines());
  const auto members = rest_of(stream);
  ASSERT_EQ(members.size(), 1u);
  EXPECT_EQ(members[0].text, text);
  EXPECT_EQ(members[0].source, name);
}

TEST_F(DocumentStreams, ReadLinesOfSeveralFilesAndNameThem) {
  const std::string lines = file("lines.jsonl", "\n{\"a\": 1}\n\n{\"a\": 2}"),
                    one = file("one.json", "{\n}\n");
  DocumentStream stream({lines, one});
  EXPECT_FALSE(stream.is_single());
  EXPECT_FALSE(stream.is_lines());
  for (int pass = 0; pass < 2; ++pass, stream.rewind()) {
    const auto members = rest_of(stream);
    ASSERT_EQ(members.size(), 3u);
    EXPECT_EQ(members[0].text, "{\"a\": 1}");
    EXPECT_EQ(members[0].source, lines + " line 2");
    EXPECT_EQ(members[1].text, "{\"a\": 2}");
    EXPECT_EQ(members[1].source, lines + " line 4");
    EXPECT_EQ(members[2].source, one);
    for (int m = 0; m < 3; ++m) EXPECT_EQ(members[m].number, m + 1);
  }
}

TEST_F(DocumentStreams, ALineIsASingleDocumentAndALine) {
  DocumentStream stream({file("line.json", "{\"a\": 1}\n")});
  EXPECT_TRUE(stream.is_single());
  EXPECT_TRUE(stream.is_lines());
  EXPECT_EQ(rest_of(stream)[0].source, path("line.json"));
}

TEST_F(DocumentStreams, AFaultyFirstLineIsAMemberOfItsOwn) {
  DocumentStream stream({file("faulty.jsonl", "{\"a\": }\n{\"a\": 2}\n")});
  const auto members = rest_of(stream);
  ASSERT_EQ(members.size(), 2u);
  EXPECT_EQ(members[0].source, path("faulty.jsonl") + " line 1");
}

TEST_F(DocumentStreams, AnEmptyFileIsOneDocumentWithoutText) {
  DocumentStream stream({file("empty.json", "\n")});
  EXPECT_TRUE(stream.is_single());
  EXPECT_FALSE(stream.is_lines());
  EXPECT_EQ(rest_of(stream).size(), 1u);
}

TEST_F(DocumentStreams, APipeCanBeReadTwice) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  std::thread writer([&] {
    std::ofstream pipe(path("pipe"));
    for (int n = 0; n < 1000; ++n)
      pipe << "{\"a\": " << n << ", \"b\": \"" << std::string(200, 'x') << "\"}\n";
  });
  DocumentStream stream({path("pipe")});
  writer.join();
  EXPECT_EQ(rest_of(stream).size(), 1000u);
  stream.rewind();
  EXPECT_EQ(rest_of(stream).back().source, path("pipe") + " line 1000");
}

TEST_F(DocumentStreams, RefuseFoldersAndMissingFiles) {
  EXPECT_THROW(DocumentStream({path("")}), InputError);
  EXPECT_THROW(DocumentStream({path("missing.json")}), InputError);
}

}  // namespace
}  // namespace beadswim
