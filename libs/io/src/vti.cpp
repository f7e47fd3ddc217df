#include "beadswim/io/vti.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdio>
#include <cstring>
#include <memory>
#include <span>

#include "beadswim/core/error.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {
namespace {

static_assert(std::endian::native == std::endian::little, "the header below says LittleEndian");

/// Base64 of a stream of bytes that comes in pieces.
class Base64 {
 public:
  explicit Base64(std::string& text) : text_(text) {}

  void append(std::span<const char> bytes) {
    for (const char byte : bytes) {
      group_ = group_ << 8 | static_cast<unsigned char>(byte);
      if (++held_ == 3) flush(4);
    }
  }

  void finish() {
    if (held_ == 0) return;
    const int digits = held_ + 1;
    for (; held_ < 3; ++held_) group_ <<= 8;
    flush(digits);
    text_.append(4 - digits, '=');
  }

 private:
  void flush(int digits) {
    constexpr char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (int d = 0; d < digits; ++d) text_ += alphabet[group_ >> (18 - 6 * d) & 63];
    group_ = 0;
    held_ = 0;
  }

  std::string& text_;
  std::uint32_t group_ = 0;
  int held_ = 0;
};

template <class T>
std::span<const char> bytes_of(const T* values, std::size_t count) {
  return {reinterpret_cast<const char*>(values), count * sizeof(T)};
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

void write_field(std::FILE* file, const Index3& cells, const VtiField& field) {
  fmt::print(file,
             "        <DataArray type=\"Float32\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">\n",
             field.name, field.components);
  const std::uint64_t size = cells.cast<std::uint64_t>().prod() * field.components * sizeof(float);
  std::string text;
  Base64 encoded(text);  // the size and the data in one stream
  encoded.append(bytes_of(&size, 1));
  for (int z = 0; z < cells[2]; ++z) {
    const std::vector<float> plane = field.plane(z);
    encoded.append(bytes_of(plane.data(), plane.size()));
    fmt::print(file, "{}", text);
    text.clear();
  }
  encoded.finish();
  fmt::print(file, "{}\n        </DataArray>\n", text);
}

}  // namespace

void write_vti(const std::string& path, const Index3& cells, double spacing,
               const std::vector<VtiField>& fields) {
  const std::string part = path + ".part";
  std::unique_ptr<std::FILE, CloseFile> file(std::fopen(part.c_str(), "wb"));
  if (!file) throw SolverError(path + " cannot be created");
  const std::string extent = fmt::format("0 {} 0 {} 0 {}", cells[0], cells[1], cells[2]);
  fmt::print(
      file.get(),
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "  <ImageData WholeExtent=\"{0}\" Origin=\"0 0 0\" Spacing=\"{1} {1} {1}\">\n"
      "    <Piece Extent=\"{0}\">\n      <CellData>\n",
      extent, spacing);
  for (const VtiField& field : fields) write_field(file.get(), cells, field);
  fmt::print(file.get(), "      </CellData>\n    </Piece>\n  </ImageData>\n</VTKFile>\n");
  const bool written = std::ferror(file.get()) == 0;
  const bool failed = std::fclose(file.release()) != 0 || !written;
  if (failed || std::rename(part.c_str(), path.c_str()) != 0) {
    throw SolverError(path + " cannot be written; is the disk full?");
  }
}

void write_pvd(const std::string& path, const std::vector<PvdEntry>& entries) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "  <Collection>\n";
  for (const PvdEntry& entry : entries) {
    text += fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", entry.time, entry.file);
  }
  text += "  </Collection>\n</VTKFile>\n";
  write_text(path, text);
}

}  // namespace beadswim
