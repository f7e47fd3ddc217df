#include "beadswim/io/xdmf.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "beadswim/io/json.hpp"
#include "beadswim/io/trajectory_reader.hpp"

namespace beadswim {
namespace {

constexpr const char* int32_type = "NumberType=\"Int\" Precision=\"4\"";
constexpr const char* float32_type = "NumberType=\"Float\" Precision=\"4\"";
constexpr const char* float64_type = "NumberType=\"Float\" Precision=\"8\"";

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

/// File name and size of a trajectory. The name has no folder, so that trajectory and index can be moved
/// together.
struct TrajectorySource {
  std::string file;
  std::size_t frames = 0, beads = 0;
};

/// Returns an attribute with one number per bead, independent of time.
std::string static_attribute(const TrajectorySource& in, const std::string& name, const char* type) {
  return fmt::format(
      "<Attribute Name=\"{0}\" AttributeType=\"Scalar\" Center=\"Node\">"
      "<DataItem Dimensions=\"{1}\" {2} Format=\"HDF\">{3}:/particles/beads/{0}</DataItem></Attribute>\n",
      name, in.beads, type, in.file);
}

/// Returns a reference to three numbers per bead in one frame.
std::string frame_slab(const TrajectorySource& in, const std::string& name, const char* type,
                       std::size_t frame) {
  return fmt::format(
      "<DataItem ItemType=\"HyperSlab\" Dimensions=\"{0} 3\">"
      "<DataItem Dimensions=\"3 3\" Format=\"XML\">{1} 0 0 1 1 1 1 {0} 3</DataItem>"
      "<DataItem Dimensions=\"{2} {0} 3\" {3} Format=\"HDF\">{4}:/particles/beads/{5}/value</DataItem>"
      "</DataItem>",
      in.beads, frame, in.frames, type, in.file, name);
}

std::string vector_attribute(const TrajectorySource& in, const std::string& name, const char* type,
                             std::size_t frame) {
  return fmt::format("<Attribute Name=\"{}\" AttributeType=\"Vector\" Center=\"Node\">{}</Attribute>\n", name,
                     frame_slab(in, name, type, frame));
}

std::string grid(const TrajectorySource& in, std::size_t frame, double time) {
  return fmt::format(
             "<Grid Name=\"beads\"><Time Value=\"{}\"/>"
             "<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{}\"/>\n"
             "<Geometry GeometryType=\"XYZ\">{}</Geometry>\n",
             time, in.beads, frame_slab(in, "position", float32_type, frame)) +
         vector_attribute(in, "velocity", float32_type, frame) +
         vector_attribute(in, "image", int32_type, frame) + static_attribute(in, "radius", float64_type) +
         static_attribute(in, "species", int32_type) + static_attribute(in, "swimmer", int32_type) +
         "</Grid>\n";
}

}  // namespace

std::string xdmf_name(const std::string& trajectory) {
  return trajectory + ".xdmf2";
}

void write_xdmf(const std::string& trajectory) {
  const TrajectoryReader reader(trajectory);
  const TrajectorySource source{.file = escaped(std::filesystem::path(trajectory).filename().string()),
                                .frames = reader.frames(),
                                .beads = reader.header().bead.size()};
  const std::vector<double> times = reader.times();
  std::string text =
      "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\"><Domain>\n"
      "<Grid Name=\"trajectory\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (std::size_t frame = 0; frame < source.frames; ++frame) text += grid(source, frame, times[frame]);
  write_text(xdmf_name(trajectory), text + "</Grid>\n</Domain></Xdmf>\n");
}

}  // namespace beadswim
