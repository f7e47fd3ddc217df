#include "layout_output.hpp"

#include <fmt/core.h>

#include <set>

#include "beadswim/core/temporary_file.hpp"
#include "beadswim/scene/check.hpp"
#include "beadswim/tools/named_flags.hpp"
#include "made_layout.hpp"

namespace beadswim {
CLI::Option* add_layout_files(CLI::App& command, std::vector<std::string>& files) {
  return add_value(command, "layout", files, {.name = "FILE", .initial = "-"},
                   "Layout files (JSON, JSON Lines); - is standard input.");
}

void filter_layouts(const std::vector<std::string>& files, const CLI::App& program, FilterOutput output,
                    const std::function<void(const StreamMember&, LayoutDocument,
                                             const std::function<void(LayoutDocument)>&)>& change) {
  DocumentStream stream(files);
  const bool is_lines = output == FilterOutput::lines || !stream.is_single() || stream.is_lines();
  const OpenFile text = temporary_file();
  const auto emit = [&](LayoutDocument layout) {
    layout.provenance.push_back(provenance_record(program));
    const Json json = layout_to_json(layout);
    append(text, is_lines ? dump_json_line(json) : dump_json(json));
  };
  while (const auto member = stream.next()) {
    LayoutDocument document = layout_of(*member);
    document.made_by = {};  // would not describe the changed layout
    change(*member, std::move(document), emit);
  }
  std::int64_t written = 0;
  for (std::string part; !(part = read_bytes(text, written, 1 << 16)).empty(); written += std::ssize(part))
    write_text("-", part);
}

void write_layout(LayoutDocument document, const CLI::App& program, std::string (*dump)(const Json&)) {
  document.provenance.push_back(provenance_record(program));
  write_text("-", dump(layout_to_json(document)));
}

void write_made_layout(const Layout& layout, const CLI::App& program, std::string (*dump)(const Json&)) {
  require_sound(layout, "the flags");
  write_layout({.layout = layout, .made_by = made_by_record(program)}, program, dump);
}

void require_sound(const Layout& layout, const std::string& source, const std::string& remedy) {
  const auto faults = check_layout(layout);
  if (faults.empty()) return;
  throw InputError("the layout made by " + source + " is invalid",
                   faults.front().place + ": " + faults.front().message + remedy);
}

void warn_of_fixed_forces(const Layout& layout) {
  static std::set<std::string> told;
  const std::string warning = warning_of_fixed_forces(layout);
  if (!warning.empty() && told.insert(warning).second)
    print_to_stderr(fmt::format("beadswim-layout: warning: {}\n", warning));
}

}  // namespace beadswim
