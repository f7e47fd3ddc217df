#include "beadswim/io/xdmf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "beadswim/core/xml_text.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/io/trajectory_reader.hpp"

namespace beadswim {
namespace {

constexpr const char* int32_type = "NumberType=\"Int\" Precision=\"4\"";
constexpr const char* float32_type = "NumberType=\"Float\" Precision=\"4\"";
constexpr const char* float64_type = "NumberType=\"Float\" Precision=\"8\"";

/// Returns an XDMF data item that refers to a dataset of the trajectory. `extents`: numbers of rows and
/// columns.
std::string dataset(const std::string& extents, const char* type, const std::string& path) {
  return fmt::format("<DataItem Dimensions=\"{}\" {} Format=\"HDF\">{}</DataItem>\n", extents, type, path);
}

/// Returns the part of a frame that is the same in all frames. The datasets of the domain are numbered
/// from 1.
std::string fixed_part(std::size_t beads) {
  std::string text = fmt::format("<Topology TopologyType='Polyvertex' NumberOfElements='{}'/>", beads);
  for (const auto& [name, number] : {std::pair{"radius", 4}, {"species", 5}, {"swimmer", 6}})
    text += fmt::format(
        "<Attribute Name='{}' AttributeType='Scalar'><DataItem "
        "Reference='/Xdmf/Domain/DataItem[{}]'/></Attribute>",
        name, number);
  return text;
}

/// Returns the declaration of what all frames share, so that each frame takes only some 400 bytes: default
/// values of attributes; `fixed`, the part of a frame that is the same in all frames; the datasets with one
/// row per frame; and `one`, which after the number of a frame selects its row.
std::string declarations(std::size_t beads) {
  std::string text = fmt::format(
      "<!DOCTYPE Xdmf [\n<!ATTLIST DataItem Dimensions CDATA \"{0} 3\">\n"
      "<!ATTLIST Attribute AttributeType CDATA \"Vector\" Center CDATA \"Node\">\n"
      "<!ENTITY fixed \"{1}\">\n<!ENTITY one \" 0 0 1 1 1 1 {0} 3\">\n",
      beads, fixed_part(beads));
  for (const auto& [name, number] : {std::pair{"position", 1}, {"velocity", 2}, {"image", 3}})
    text += fmt::format("<!ENTITY {} \"<DataItem Reference='/Xdmf/Domain/DataItem[{}]'/>\">\n", name, number);
  return text + "]>\n";
}

std::string row(std::size_t frame, const char* quantity) {
  return fmt::format(
      "<DataItem ItemType=\"HyperSlab\"><DataItem Dimensions=\"3 3\">{}&one;</DataItem>&{};</DataItem>",
      frame, quantity);
}

std::string grid(std::size_t frame) {
  return fmt::format(
      "<Grid Name=\"beads\">&fixed;<Geometry>{}</Geometry><Attribute Name=\"velocity\">{}</Attribute>"
      "<Attribute Name=\"image\">{}</Attribute></Grid>\n",
      row(frame, "position"), row(frame, "velocity"), row(frame, "image"));
}

}  // namespace

std::string xdmf_name(const std::string& trajectory) {
  return trajectory + ".xdmf2";
}

bool paraview_can_open(const std::string& path) {
  const std::string name = std::filesystem::path(path).filename().string();
  const auto is_readable = [](char c) { return c >= ' ' && c <= '}' && c != ':' && c != '\\'; };
  return !name.starts_with(' ') && std::ranges::all_of(name, is_readable);
}

void write_xdmf(const std::string& trajectory) {
  const TrajectoryReader reader(trajectory);
  const std::size_t frames = reader.frames(), beads = reader.header().bead.size();
  // The name has no folder, so that trajectory and index can be moved together.
  const std::string data =
      xml_text(std::filesystem::path(trajectory).filename().string()) + ":/particles/beads/";
  std::string text = "<?xml version=\"1.0\"?>\n" + declarations(beads) + "<Xdmf Version=\"2.0\"><Domain>\n";
  for (const auto& [name, type] :
       {std::pair{"position", float32_type}, {"velocity", float32_type}, {"image", int32_type}})
    text += dataset(fmt::format("{} {} 3", frames, beads), type, fmt::format("{}{}/value", data, name));
  for (const auto& [name, type] :
       {std::pair{"radius", float64_type}, {"species", int32_type}, {"swimmer", int32_type}})
    text += dataset(fmt::format("{}", beads), type, data + name);
  text +=
      "<Grid Name=\"trajectory\" GridType=\"Collection\" CollectionType=\"Temporal\">\n"
      "<Time TimeType=\"List\">" +
      dataset(fmt::format("{}", frames), float64_type, data + "position/time") + "</Time>\n";
  for (std::size_t frame = 0; frame < frames; ++frame) text += grid(frame);
  write_text(xdmf_name(trajectory), text + "</Grid>\n</Domain></Xdmf>\n");
}

}  // namespace beadswim
