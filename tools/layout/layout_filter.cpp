#include "layout_filter.hpp"

#include <fmt/core.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "beadswim/core/error.hpp"
#include "beadswim/tools/program.hpp"

namespace beadswim {
namespace {

/// Text that waits in a temporary file until it is written to standard output.
class WaitingText {
 public:
  WaitingText() : file_(std::tmpfile(), &std::fclose) {}

  void add(const std::string& text) {
    if (!file_ || std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) fail();
  }
  void write() {
    if (!file_ || std::fflush(file_.get()) != 0) fail();
    std::rewind(file_.get());
    std::array<char, 1 << 16> part;
    for (std::size_t size; (size = std::fread(part.data(), 1, part.size(), file_.get())) > 0;)
      write_text("-", std::string(part.data(), size));
  }

 private:
  [[noreturn]] static void fail() {
    throw SolverError(
        fmt::format("a temporary file cannot be written: {}; set TMPDIR to a folder with "
                    "free space",
                    std::strerror(errno)));
  }

  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

}  // namespace

CLI::Option* add_layout_files(CLI::App& command, std::vector<std::string>& files) {
  return command.add_option("layout", files, "Layout files (JSON, JSON Lines); - is standard input.")
      ->type_name("FILE")
      ->default_str("-");
}

LayoutDocument layout_of(const StreamMember& member) {
  return layout_from_json(parse_json(member.text, member.source), member.source);
}

void filter_layouts(const std::vector<std::string>& files, const CLI::App& program, FilterOutput output,
                    const std::function<void(const StreamMember&, LayoutDocument,
                                             const std::function<void(LayoutDocument)>&)>& change) {
  DocumentStream stream(files);
  const bool is_lines = output == FilterOutput::lines || !stream.is_single() || stream.is_lines();
  WaitingText text;
  const auto emit = [&](LayoutDocument layout) {
    layout.provenance.push_back(provenance_record(program));
    const Json json = layout_to_json(layout);
    text.add(is_lines ? dump_json_line(json) : dump_json(json));
  };
  while (const auto member = stream.next()) change(*member, layout_of(*member), emit);
  text.write();
}

}  // namespace beadswim
