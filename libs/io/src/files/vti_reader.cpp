#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <sstream>

#include "beadswim/core/error.hpp"
#include "beadswim/core/xml_text.hpp"
#include "beadswim/io/base64.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/io/vti.hpp"

namespace beadswim {
namespace {

constexpr std::int64_t max_tag_bytes = 1024;  // of the text before the first field, and of the tag of a field
constexpr std::int64_t max_plane_bytes = 1 << 30;
constexpr double largest = 1e100;  // edge of a cell, and its reciprocal

/// Returns the value of an attribute of an XML tag as it stands in the text; empty if there is none.
std::string attribute(const std::string& tag, const std::string& name) {
  const std::size_t found = tag.find(" " + name + "=\"");
  if (found == std::string::npos) return "";
  const std::size_t start = found + name.size() + 3;
  return tag.substr(start, tag.find('"', start) - start);
}

/// Returns the numbers of a text, between spaces; empty if it contains anything else.
template <class Number>
std::vector<Number> numbers_in(const std::string& text) {
  std::istringstream words(text);
  std::vector<Number> numbers;
  for (std::string word; words >> word;) {
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), numbers.emplace_back());
    if (fault != std::errc() || end != word.data() + word.size()) return {};
  }
  return numbers;
}

std::int64_t base64_bytes(std::int64_t bytes) {
  return (bytes + 2) / 3 * 4;
}

}  // namespace

VtiReader::VtiReader(const std::string& path) : path_(path), file_(open_input(path)) {
  if (std::fseek(file_.get(), 0, SEEK_END) == 0) file_bytes_ = std::ftell(file_.get());
  const std::string header = read_bytes(file_, 0, max_tag_bytes);
  const std::string before_fields = "<CellData>";
  const std::size_t end = header.find(before_fields);
  if (end == std::string::npos) refuse("it does not begin as VTK image data with fields on cells");
  read_cells(header.substr(0, end));
  auto next = static_cast<std::int64_t>(end + before_fields.size());
  while (next != 0) next = read_field(next);
}

void VtiReader::refuse(const std::string& fault) const {
  throw InputError(path_, fault + "; give a flow file (.vti) as beadswim-run wrote it");
}

void VtiReader::read_cells(const std::string& header) {
  if (attribute(header, "type") != "ImageData" || attribute(header, "byte_order") != "LittleEndian" ||
      attribute(header, "header_type") != "UInt64")
    refuse("it is not VTK image data of the form that runs write");
  const std::vector<int> extent = numbers_in<int>(attribute(header, "WholeExtent"));
  const std::vector<double> origin = numbers_in<double>(attribute(header, "Origin")),
                            spacing = numbers_in<double>(attribute(header, "Spacing"));
  if (extent.size() != 6 || origin.size() != 3 || spacing.size() != 3)
    refuse("its cells are not described by WholeExtent, Origin and Spacing");
  const double edge = spacing[0];
  double cells = 1;
  for (int a = 0; a < 3; ++a) {
    cells_.cells[a] = extent[2 * a + 1];
    cells_.origin[a] = origin[a];
    cells *= cells_.cells[a];
    if (extent[2 * a] != 0 || cells_.cells[a] < 1 || spacing[a] != edge)
      refuse("its cells are not a box of cubes that are numbered from 0");
    const bool is_resolved = origin[a] + edge > origin[a] && std::abs(origin[a]) < largest;  // also not NaN
    if (!(edge > 1 / largest && edge < largest && is_resolved))
      refuse("its cells have no usable size and place");
  }
  if (cells > static_cast<double>(file_bytes_)) refuse("it is shorter than its cells need");
  cells_.spacing = edge;
  const auto read_number = [&](const char* name, std::optional<int>& value) {
    const std::size_t tag = header.find(fmt::format(" Name=\"{}\"", name)), text = header.find('>', tag);
    if (tag == std::string::npos) return;
    const auto numbers = numbers_in<int>(header.substr(text + 1, header.find('<', text) - text - 1));
    if (numbers.size() != 1) refuse(fmt::format("its {} is not a number", name));
    value = numbers[0];
  };
  VtiCells::visit_numbers(read_number, cells_);
}

/// Reads the description of the field after `start`. Returns the end of the field in the file, or 0 if there
/// is no further field.
std::int64_t VtiReader::read_field(std::int64_t start) {
  const std::string text = read_bytes(file_, start, max_tag_bytes);
  const std::size_t tag = text.find_first_not_of(" \n"), data = text.find(">\n", tag);
  if (tag == std::string::npos) refuse("it ends before its last field");
  if (text.compare(tag, 11, "</CellData>") == 0) return 0;
  if (text.compare(tag, 10, "<DataArray") != 0 || data == std::string::npos)
    refuse("what follows its fields is not a field");
  const std::string description = text.substr(tag, data - tag), name = attribute(description, "Name");
  const auto place = [&](const std::string& fault) {
    return fmt::format("its field \"{}\" {}", name, fault);
  };
  const std::vector<int> components = numbers_in<int>(attribute(description, "NumberOfComponents"));
  const std::string type = attribute(description, "type");
  if (components.size() != 1 || components[0] < 1 || components[0] > 9 ||
      (type != "Float32" && type != "UInt8") || attribute(description, "format") != "binary")
    refuse(place("does not consist of Float32 or UInt8 in binary form"));
  const StoredField field{.components = components[0],
                          .is_small_integer = type == "UInt8",
                          .start = start + static_cast<std::int64_t>(data) + 2};
  const std::int64_t cells = cells_.cells.cast<std::int64_t>().prod();
  const std::int64_t size = cells * field.components * field.number_size(), header_size = sizeof(size);
  const std::int64_t end = field.start + base64_bytes(header_size + size);
  if (end > file_bytes_) refuse(place("is incomplete"));
  std::uint64_t stated = 0;
  std::memcpy(&stated, decoded(field.start, 0, header_size).data(), sizeof(stated));
  if (stated != static_cast<std::uint64_t>(size)) refuse(place("has another size than its cells"));
  const std::string closing = "\n        </DataArray>\n";
  if (read_bytes(file_, end, std::ssize(closing)) != closing)
    refuse(place("does not end after its last cell"));
  fields_.emplace(name, field);
  return end + std::ssize(closing);
}

std::string VtiReader::decoded(std::int64_t start, std::int64_t first_byte, std::int64_t bytes) const {
  const std::int64_t group = first_byte / 3, end = (first_byte + bytes + 2) / 3;
  const std::optional<std::string> all =
      decoded_base64(read_bytes(file_, start + 4 * group, 4 * (end - group)));
  if (!all) refuse("it contains characters that are not Base64 text");
  return all->substr(first_byte - 3 * group, bytes);
}

std::vector<float> VtiReader::plane(const std::string& name, int components, int z) const {
  const auto found = fields_.find(name);
  if (found == fields_.end() || found->second.components != components)
    refuse(fmt::format("it has no field \"{}\" with {} component{}", name, components,
                       components == 1 ? "" : "s"));
  const StoredField& field = found->second;
  const std::int64_t numbers = cells_.cells.head<2>().cast<std::int64_t>().prod() * components;
  const std::int64_t bytes = numbers * field.number_size(), header = sizeof(std::uint64_t);
  if (bytes > max_plane_bytes) refuse("its planes of cells are too large to be read");
  const std::string data = decoded(field.start, header + z * bytes, bytes);
  std::vector<float> plane(numbers);
  if (field.is_small_integer) {
    std::ranges::transform(data, plane.begin(), [](char c) { return static_cast<unsigned char>(c); });
  } else {
    std::memcpy(plane.data(), data.data(), data.size());
  }
  if (!std::ranges::all_of(plane, [](float number) { return std::isfinite(number); }))
    refuse(fmt::format("its field \"{}\" contains a number that is not finite", name));
  return plane;
}

std::vector<PvdEntry> read_pvd(const std::string& path) {
  const std::string text = read_text(path);
  std::vector<PvdEntry> entries;
  for (std::size_t at = text.find("<DataSet "); at != std::string::npos;
       at = text.find("<DataSet ", at + 1)) {
    const std::string tag = text.substr(at, text.find("/>", at) - at);
    const std::vector<double> time = numbers_in<double>(attribute(tag, "timestep"));
    const std::vector<int> part = numbers_in<int>(attribute(tag, "part"));
    PvdEntry entry{.file = plain_text(attribute(tag, "file"))};
    if (time.size() != 1 || !std::isfinite(time[0]) || part.size() != 1 || entry.file.empty())
      throw InputError(path,
                       "entry {} has no time, part or file; give an index (.pvd) as beadswim-run wrote it",
                       entries.size() + 1);
    entry.time = time[0];
    entry.part = part[0];
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace beadswim
