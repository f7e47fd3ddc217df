#include "beadswim/io/vti.hpp"

#include <fmt/core.h>

#include <bit>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <span>

#include "beadswim/core/error.hpp"
#include "beadswim/core/temporary_file.hpp"
#include "beadswim/core/xml_text.hpp"
#include "beadswim/io/base64.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {
namespace {

static_assert(std::endian::native == std::endian::little, "the header below says LittleEndian");

/// Writes text without a check for errors. The caller checks with ferror at the end of the file.
void put(std::FILE* file, const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), file);
}

void write_field(std::FILE* file, const Index3& cells, const VtiField& field) {
  put(file,
      fmt::format("        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">\n",
                  field.is_small_integer ? "UInt8" : "Float32", field.name, field.components));
  const std::uint64_t number_size = field.is_small_integer ? 1 : sizeof(float);
  const std::uint64_t size = cells.cast<std::uint64_t>().prod() * field.components * number_size;
  std::string bytes;  // bytes of the stream (size, then data) that are not yet written
  const auto append = [&bytes](std::span<const char> more) { bytes.append(more.begin(), more.end()); };
  append(bytes_of(std::span(&size, 1)));
  for (int z = 0; z < cells[2]; ++z) {
    const std::vector<float> plane = field.plane(z);
    if (field.is_small_integer) {
      append(std::vector<char>(plane.begin(), plane.end()));
    } else {
      append(bytes_of(std::span(plane)));
    }
    const std::size_t complete_bytes = bytes.size() / 3 * 3;
    put(file, base64(std::span(bytes).first(complete_bytes)));
    bytes.erase(0, complete_bytes);
  }
  put(file, base64(bytes) + "\n        </DataArray>\n");
}

}  // namespace

void write_vti(const std::string& path, const VtiCells& grid, const std::vector<VtiField>& fields) {
  const Index3& cells = grid.cells;
  const std::string part = path + ".part";
  OpenFile file(std::fopen(part.c_str(), "wb"));
  if (!file) throw SolverError(fmt::format("{} cannot be created: {}", path, std::strerror(errno)));
  std::string numbers;
  const auto add_number = [&](const char* name, const std::optional<int>& value) {
    if (value)
      numbers += fmt::format(
          "      <DataArray type=\"Float64\" Name=\"{}\" NumberOfTuples=\"1\" "
          "format=\"ascii\">{}</DataArray>\n",
          name, *value);
  };
  VtiCells::visit_numbers(add_number, grid);
  if (!numbers.empty()) numbers = "    <FieldData>\n" + numbers + "    </FieldData>\n";
  const std::string extent = fmt::format("0 {} 0 {} 0 {}", cells[0], cells[1], cells[2]);
  put(file.get(),
      fmt::format(
          "<?xml version=\"1.0\"?>\n"
          "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
          "  <ImageData WholeExtent=\"{0}\" Origin=\"{2} {3} {4}\" Spacing=\"{1} {1} {1}\">\n"
          "{5}    <Piece Extent=\"{0}\">\n      <CellData>\n",
          extent, grid.spacing, grid.origin[0], grid.origin[1], grid.origin[2], numbers));
  for (const VtiField& field : fields) write_field(file.get(), cells, field);
  put(file.get(), "      </CellData>\n    </Piece>\n  </ImageData>\n</VTKFile>\n");
  const bool written = std::ferror(file.get()) == 0;
  const bool failed = std::fclose(file.release()) != 0 || !written;
  if (failed || std::rename(part.c_str(), path.c_str()) != 0) {
    std::remove(part.c_str());  // frees the disk space
    throw SolverError(path + ": the file cannot be written; is the disk full?");
  }
}

void write_pvd(const std::string& path, const std::vector<PvdEntry>& entries) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "  <Collection>\n";
  for (const PvdEntry& entry : entries) {
    text += fmt::format("    <DataSet timestep=\"{}\" part=\"{}\" file=\"{}\"/>\n", entry.time, entry.part,
                        xml_text(entry.file));
  }
  text += "  </Collection>\n</VTKFile>\n";
  write_text(path, text);
}

}  // namespace beadswim
