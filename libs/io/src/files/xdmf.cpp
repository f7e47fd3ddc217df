#include "beadswim/io/xdmf.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "beadswim/io/json.hpp"
#include "beadswim/io/trajectory_reader.hpp"

namespace beadswim {
namespace {

constexpr const char* whole_numbers = "NumberType=\"Int\" Precision=\"4\"";
constexpr const char* single_precision = "NumberType=\"Float\" Precision=\"4\"";
constexpr const char* double_precision = "NumberType=\"Float\" Precision=\"8\"";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else {
      result += c;
    }
  }
  return result;
}

/// Where things are in one trajectory. It is named without its folder, so that both can be moved together.
struct Places {
  std::string file;
  std::size_t frames = 0, beads = 0;
};

/// Numbers that each bead keeps.
std::string fixed(const Places& in, const std::string& name, const char* type) {
  return fmt::format(
      "<Attribute Name=\"{0}\" AttributeType=\"Scalar\" Center=\"Node\">"
      "<DataItem Dimensions=\"{1}\" {2} Format=\"HDF\">{3}:/particles/beads/{0}</DataItem></Attribute>\n",
      name, in.beads, type, in.file);
}

/// Three numbers a bead, of one frame.
std::string slab(const Places& in, const std::string& name, const char* type, std::size_t frame) {
  return fmt::format(
      "<DataItem ItemType=\"HyperSlab\" Dimensions=\"{0} 3\">"
      "<DataItem Dimensions=\"3 3\" Format=\"XML\">{1} 0 0 1 1 1 1 {0} 3</DataItem>"
      "<DataItem Dimensions=\"{2} {0} 3\" {3} Format=\"HDF\">{4}:/particles/beads/{5}/value</DataItem>"
      "</DataItem>",
      in.beads, frame, in.frames, type, in.file, name);
}

std::string vectors(const Places& in, const std::string& name, const char* type, std::size_t frame) {
  return fmt::format("<Attribute Name=\"{}\" AttributeType=\"Vector\" Center=\"Node\">{}</Attribute>\n", name,
                     slab(in, name, type, frame));
}

std::string grid(const Places& in, std::size_t frame, double time) {
  return fmt::format(
             "<Grid Name=\"beads\"><Time Value=\"{}\"/>"
             "<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{}\"/>\n"
             "<Geometry GeometryType=\"XYZ\">{}</Geometry>\n",
             time, in.beads, slab(in, "position", single_precision, frame)) +
         vectors(in, "velocity", single_precision, frame) + vectors(in, "image", whole_numbers, frame) +
         fixed(in, "radius", double_precision) + fixed(in, "species", whole_numbers) +
         fixed(in, "swimmer", whole_numbers) + "</Grid>\n";
}

}  // namespace

std::string xdmf_name(const std::string& trajectory) {
  return trajectory + ".xdmf2";
}

void write_xdmf(const std::string& trajectory) {
  const TrajectoryReader reader(trajectory);
  const Places places{.file = escaped(std::filesystem::path(trajectory).filename().string()),
                      .frames = reader.frames(),
                      .beads = reader.header().bead.size()};
  const std::vector<double> times = reader.times();
  std::string text =
      "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\"><Domain>\n"
      "<Grid Name=\"trajectory\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (std::size_t frame = 0; frame < places.frames; ++frame) text += grid(places, frame, times[frame]);
  write_text(xdmf_name(trajectory), text + "</Grid>\n</Domain></Xdmf>\n");
}

}  // namespace beadswim
