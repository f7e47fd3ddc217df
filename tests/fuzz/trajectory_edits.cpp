#include "trajectory_edits.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "accepted.hpp"
#include "beadswim/io/hdf5.hpp"

namespace beadswim {
namespace {

using namespace std::string_literals;

enum class Form { dataset, attribute, group, missing, dangling_link };

struct Item {
  std::string place, attribute;
  hid_t type;  ///< number type in the file
  std::vector<hsize_t> shape;
  std::vector<double> numbers;  ///< as many as the shape requires, unless it was edited
  std::string text;
  Form form = Form::dataset;
};

constexpr hsize_t most_stored = 4096;  ///< numbers; what is larger has no storage

const char* const layout_text =
    R"({"schema":"beadswim/layout/1","units":"lattice","fluid":{"density":1,"kinematic_viscosity":0.3},)"
    R"("domain":{"lengths":[60,40,40],"boundary":["periodic","periodic","periodic"]},)"
    R"("types":{"a":{"beads":[{"radius":4,"density":1},{"radius":4,"density":1},{"radius":4,"density":1}],)"
    R"("springs":[{"stiffness":0.03,"rest_length":20,"damping":0},{"stiffness":0.03,"rest_length":20,"damping":0}],)"
    R"("angular_stiffness":9,"driving":{"amplitude":[0.2,0.2],"phase":1.5,"period":2000}}},)"
    R"("swimmers":[{"id":0,"type":"a","position":[30,10,20],"axis":[1,0,0]},)"
    R"({"id":1,"type":"a","position":[30,30,20],"axis":[1,0,0]}]})";

/// Returns the contents of a valid trajectory with two swimmers, two frames and one cycle.
std::vector<Item> sound_items() {
  const hid_t real = H5T_IEEE_F64LE, single = H5T_IEEE_F32LE, whole = H5T_STD_I32LE, text = H5T_C_S1;
  std::vector<double> positions;
  for (const double x : {10, 30, 50, 12, 30, 48}) positions.insert(positions.end(), {x, 20, 20});
  positions.insert(positions.end(), positions.begin(), positions.end());
  const std::vector<double> none(36), edges{60, 0, 0, 0, 40, 0, 0, 0, 40, 60, 0, 0, 0, 40, 0, 0, 0, 40};
  std::vector<Item> items{
      {"particles/beads/species", "", whole, {6}, {1, 2, 3, 1, 2, 3}, ""},
      {"particles/beads/swimmer", "", whole, {6}, {0, 0, 0, 1, 1, 1}, ""},
      {"particles/beads/radius", "", real, {6}, {4, 4, 4, 4, 4, 4}, ""},
      {"particles/beads/position/step", "", whole, {2}, {0, 50}, ""},
      {"particles/beads/position/time", "", real, {2}, {0, 50}, ""},
      {"particles/beads/position/value", "", single, {2, 6, 3}, positions, ""},
      {"particles/beads/image/value", "", whole, {2, 6, 3}, none, ""},
      {"particles/beads/velocity/value", "", single, {2, 6, 3}, none, ""},
      {"particles/beads/box/edges/value", "", real, {2, 3, 3}, edges, ""},
      {"observables/mean_flow/value", "", real, {2, 3}, std::vector<double>(6), ""},
      {"observables/momentum/value", "", real, {2, 3}, std::vector<double>(6), ""},
      {"particles/beads/box", "boundary", text, {3}, {}, "periodicperiodicnone\0\0\0\0"s, Form::attribute},
      {"h5md/creator", "version", text, {}, {}, "0.1.0", Form::attribute},
      {"parameters/layout", "", text, {}, {}, layout_text},
      {"swimmers/velocity/step", "", whole, {1}, {100}, ""},
      {"swimmers/velocity/time", "", real, {1}, {100}, ""}};
  for (const std::string name : {"velocity", "axis", "mean_flow"})
    items.push_back({"swimmers/" + name + "/value", "", real, {1, 2, 3}, std::vector<double>(6), ""});
  for (const std::string name : {"arm_amplitudes", "arm_phases", "arm_means"})
    items.push_back({"swimmers/" + name + "/value", "", real, {1, 2, 2}, std::vector<double>(4), ""});
  return items;
}

double odd_number(ByteSource& edits) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                   inf = std::numeric_limits<double>::infinity();
  constexpr std::array odd{nan, inf, -inf,  0.0,    -1.0, 1.0,          2.0,
                           3.0, 0.5, 1e300, -1e300, 1e9,  2147483647.0, 5e-324};
  const std::size_t which = edits.choice(odd.size() + 1);
  return which < odd.size() ? odd[which] : edits.take<double>();
}

hsize_t odd_extent(ByteSource& edits) {
  constexpr std::array<hsize_t, 14> odd{
      0, 1, 2, 3, 4, 6, 9, 1000, 1'000'000, 99'999'999, 300'000'000, hsize_t{1} << 32, hsize_t{1} << 61, 12};
  return odd[edits.choice(odd.size())];
}

hid_t odd_type(ByteSource& edits) {
  const std::array<hid_t, 10> odd{H5T_STD_I8LE,    H5T_STD_I32BE, H5T_STD_U64LE, H5T_IEEE_F32BE,
                                  H5T_IEEE_F64LE,  H5T_C_S1,      H5T_STD_B8LE,  H5T_STD_I64LE,
                                  H5T_STD_REF_OBJ, H5T_IEEE_F64BE};
  return odd[edits.choice(odd.size())];
}

void edit(Item& item, ByteSource& edits) {
  switch (edits.choice(8)) {
    case 0:
      item.form = static_cast<Form>(edits.choice(5));
      break;
    case 1:
      item.type = odd_type(edits);
      break;
    case 2:
      if (!item.shape.empty()) item.shape[edits.choice(item.shape.size())] = odd_extent(edits);
      break;
    case 3:
      item.shape.insert(item.shape.begin(), odd_extent(edits));
      break;
    case 4:
      if (!item.shape.empty()) item.shape.pop_back();
      break;
    case 5:
      item.text = edits.text(edits.take<std::uint8_t>());
      break;
    case 6: {
      const std::size_t at = edits.choice(item.text.size() + 1);
      item.text.replace(at, edits.choice(16), edits.text(edits.choice(16)));
      break;
    }
    default:
      if (!item.numbers.empty()) item.numbers[edits.choice(item.numbers.size())] = odd_number(edits);
  }
}

void make_groups(const H5File& file, const std::string& place) {
  for (std::size_t slash = place.find('/'); slash != std::string::npos; slash = place.find('/', slash + 1)) {
    const std::string group = place.substr(0, slash);
    if (!file.contains(group)) file.create_group(group);
  }
}

H5Handle type_of(const Item& item) {
  H5Handle type(H5Tcopy(item.type), item.place);
  if (H5Tget_class(type) != H5T_STRING) return type;
  const std::size_t count = item.shape.size() == 1 ? std::clamp<std::size_t>(item.shape[0], 1, 3) : 1;
  H5Tset_size(type, item.text.empty() ? H5T_VARIABLE : (item.text.size() + count - 1) / count);
  return type;
}

hsize_t count_of(const Item& item) {
  return std::accumulate(item.shape.begin(), item.shape.end(), hsize_t{1}, std::multiplies<>());
}

/// Writes numbers or text to a dataset if there are as many as its shape requires.
void fill(hid_t dataset, const Item& item, const H5Handle& type) {
  const bool is_text = H5Tget_class(type) == H5T_STRING;
  if (is_text && H5Tis_variable_str(type) == 0 && count_of(item) <= 3) {
    const std::string padded = item.text + std::string(H5Tget_size(type) * count_of(item), '\0');
    H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data());
  } else if (!is_text && count_of(item) == item.numbers.size()) {
    H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, item.numbers.data());
  }
}

void write_dataset(hid_t file, const Item& item, const H5Handle& type, const H5Handle& space) {
  const H5Handle creation(H5Pcreate(H5P_DATASET_CREATE), item.place);
  const std::vector<hsize_t> chunk(item.shape.size(), 1);
  const bool is_large = std::ranges::any_of(item.shape, [](hsize_t n) { return n > most_stored; });
  if (is_large) H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data());
  H5Pset_obj_track_times(creation, false);
  const hid_t dataset = H5Dcreate2(file, item.place.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  if (dataset < 0) return;
  const H5Handle owned(dataset, item.place);
  if (!is_large) fill(owned, item, type);
}

void write_item(const H5File& file, const Item& item) {
  make_groups(file, item.place + (item.form == Form::attribute ? "/" : ""));
  if (item.form == Form::missing) return;
  if (item.form == Form::group) return static_cast<void>(make_groups(file, item.place + "/"));
  if (item.form == Form::dangling_link)
    return static_cast<void>(H5Lcreate_soft("/nowhere", file, item.place.c_str(), H5P_DEFAULT, H5P_DEFAULT));
  const H5Handle type = type_of(item);
  const hid_t made = H5Screate_simple(static_cast<int>(item.shape.size()), item.shape.data(), nullptr);
  if (made < 0) return;
  const H5Handle space(made, item.place);
  if (item.form == Form::dataset) return write_dataset(file, item, type, space);
  const hid_t parent = H5Oopen(file, item.place.c_str(), H5P_DEFAULT);
  if (parent < 0) return;
  const H5Handle object(parent, item.place);
  if (count_of(item) > 64) return;
  const std::string name = item.attribute.empty() ? "name" : item.attribute;
  const hid_t attribute = H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT);
  if (attribute < 0) return;
  const H5Handle owned(attribute, item.place);
  const std::string padded = item.text + std::string(1024, '\0');
  if (H5Tis_variable_str(type) <= 0 && H5Tget_size(type) * count_of(item) <= padded.size())
    H5Awrite(owned, type, padded.data());
}

}  // namespace

void write_edited_trajectory(const std::string& path, ByteSource& edits) {
  std::vector<Item> items = sound_items();
  while (!edits.is_at_end()) edit(items[edits.choice(items.size())], edits);
  const H5File file(path, H5File::Mode::create, "");
  for (const Item& item : items) write_item(file, item);
}

}  // namespace beadswim
