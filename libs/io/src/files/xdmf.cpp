#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "beadswim/core/xml_text.hpp"
#include "beadswim/io/h5md.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {
namespace {

constexpr const char* int32_type = "NumberType=\"Int\" Precision=\"4\"";
constexpr const char* float32_type = "NumberType=\"Float\" Precision=\"4\"";
constexpr const char* float64_type = "NumberType=\"Float\" Precision=\"8\"";

struct Quantity {
  const char *name, *type;
};
constexpr std::array<Quantity, 3> moving{
    {{"position", float32_type}, {"velocity", float32_type}, {"image", int32_type}}};
constexpr std::array<Quantity, 3> fixed{
    {{"radius", float64_type}, {"species", int32_type}, {"swimmer", int32_type}}};

/// Returns an XDMF data item that refers to a dataset of the trajectory.
std::string dataset(const std::string& extents, const char* type, const std::string& path) {
  return fmt::format("<DataItem Dimensions=\"{}\" {} Format=\"HDF\">{}</DataItem>\n", extents, type, path);
}

/// Returns the declaration of what all frames share, so that each frame takes only some 400 bytes: default
/// values of attributes; `one`, which after the number of a frame selects its row; an entity for each moving
/// quantity; and `fixed`, the part of a frame that does not move. Datasets of the domain are numbered from 1.
std::string declarations(std::size_t beads) {
  std::string text = fmt::format(
      "<!DOCTYPE Xdmf [\n<!ATTLIST DataItem Dimensions CDATA \"{0} 3\">\n"
      "<!ATTLIST Attribute AttributeType CDATA \"Vector\" Center CDATA \"Node\">\n"
      "<!ENTITY one \" 0 0 1 1 1 1 {0} 3\">\n",
      beads);
  int number = 0;
  for (const Quantity& quantity : moving)
    text += fmt::format("<!ENTITY {} \"<DataItem Reference='/Xdmf/Domain/DataItem[{}]'/>\">\n", quantity.name,
                        ++number);
  text += fmt::format("<!ENTITY fixed \"<Topology TopologyType='Polyvertex' NumberOfElements='{}'/>", beads);
  for (const Quantity& quantity : fixed)
    text += fmt::format(
        "<Attribute Name='{}' AttributeType='Scalar'><DataItem "
        "Reference='/Xdmf/Domain/DataItem[{}]'/></Attribute>",
        quantity.name, ++number);
  return text + "\">\n]>\n";
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
  for (const auto& [name, type] : moving)
    text += dataset(fmt::format("{} {} 3", frames, beads), type, fmt::format("{}{}/value", data, name));
  for (const auto& [name, type] : fixed) text += dataset(fmt::format("{}", beads), type, data + name);
  text +=
      "<Grid Name=\"trajectory\" GridType=\"Collection\" CollectionType=\"Temporal\">\n"
      "<Time TimeType=\"List\">" +
      dataset(fmt::format("{}", frames), float64_type, data + "position/time") + "</Time>\n";
  for (std::size_t frame = 0; frame < frames; ++frame) text += grid(frame);
  // For .xdmf2, ParaView uses the XDMF reader that can select one frame of a dataset; for .xdmf, another one.
  write_text(trajectory + ".xdmf2", text + "</Grid>\n</Domain></Xdmf>\n");
}

}  // namespace beadswim
