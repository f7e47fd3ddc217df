#include "beadswim/io/checkpoint_file.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <type_traits>

#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"
#include "part_file.hpp"

namespace beadswim {
namespace {

constexpr const char* format_name = "beadswim/checkpoint/1";
constexpr const char* lattice_name = "lattice";

/// Returns the name of the dataset of a lattice: lattice, lattice1, lattice2, ...
std::string name_of_lattice(int lattice) {
  return lattice == 0 ? lattice_name : fmt::format("{}{}", lattice_name, lattice);
}

constexpr hsize_t max_piece_bytes = hsize_t{1}
                                    << 26;  ///< maximum number of bytes per read or write operation

template <class Real>
hid_t file_type() {
  return std::is_same_v<Real, float> ? H5T_IEEE_F32LE : H5T_IEEE_F64LE;
}
template <class Real>
hid_t memory_type() {
  return std::is_same_v<Real, float> ? H5T_NATIVE_FLOAT : H5T_NATIVE_DOUBLE;
}

H5Handle parallel_access(const Communicator& communicator, const std::string& path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // exceptions replace HDF5's error messages on stderr
  H5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, path);
  check_hdf5(H5Pset_fapl_mpio(access, communicator.get(), MPI_INFO_NULL), path);
  return access;
}

H5Handle create_file(const std::string& path, const Communicator& communicator) {
  const H5Handle access = parallel_access(communicator, path);
  const hid_t file = H5Fcreate(part_name(path).c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
  if (file < 0) throw SolverError(part_name(path) + ": the checkpoint cannot be created; is the disk full?");
  return {file, H5Fclose, path};
}

/// Returns true on all ranks if `yes` is true on all ranks. Collective.
bool all_agree(bool yes, const Communicator& communicator) {
  int all = yes ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &all, 1, MPI_INT, MPI_MIN, communicator.get());
  return all == 1;
}

H5Handle open_file(const std::string& path, const Communicator& communicator) {
  // Rank 0 first checks that the file exists and is an HDF5 file, before all ranks open it in parallel.
  const bool is_hdf5 = !communicator.is_root() || H5Fis_hdf5(path.c_str()) > 0;
  if (!all_agree(is_hdf5, communicator))
    throw InputError(path,
                     "the file is not a checkpoint, or cannot be read; name FILE.h5md.ckpt.0, "
                     "FILE.h5md.ckpt.1 or FILE.h5md");
  const H5Handle access = parallel_access(communicator, path);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
  if (!all_agree(file >= 0, communicator))
    throw InputError(path, fmt::format("the file is not a checkpoint, or is damaged; take the run's other "
                                       "checkpoint (.ckpt.0 or .ckpt.1), or begin without {}",
                                       Setting::restart));
  return {file, H5Fclose, path};
}

/// Dataspaces of one rank's part of a dataset, in the file and in memory.
struct Selection {
  H5Handle file, memory;
};

Selection select(const H5Handle& dataset, std::span<const hsize_t> start, std::span<const hsize_t> count,
                 const std::string& what) {
  Selection selection{
      {H5Dget_space(dataset), H5Sclose, what},
      {H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr), H5Sclose, what}};
  check_hdf5(
      H5Sselect_hyperslab(selection.file, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
      what);
  return selection;
}

H5Handle transfer_mode(H5FD_mpio_xfer_t mode, const std::string& what) {
  H5Handle transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose, what);
  check_hdf5(H5Pset_dxpl_mpio(transfer, mode), what);
  return transfer;
}

// Return start and extents of one component of `part` in the dataset [component][z][y][x].
std::array<hsize_t, 4> start_of(const LatticePart& part, int component) {
  return {hsize_t(component), hsize_t(part.offset[2]), hsize_t(part.offset[1]), hsize_t(part.offset[0])};
}
std::array<hsize_t, 4> count_of(const LatticePart& part) {
  return {1, hsize_t(part.size[2]), hsize_t(part.size[1]), hsize_t(part.size[0])};
}

/// Adds the numbers of one component of a part to the hash. Each number enters the hash with its index in the
/// complete lattice, so that the hash does not depend on the division into parts. Lattices count as further
/// components.
template <class Real>
void add_to(LatticeHash& hash, const LatticePart& part, int component, std::span<const Real> numbers) {
  using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  const Index3 &n = part.cells, &at = part.offset, &size = part.size;
  std::size_t next = 0;
  for (int z = 0; z < size[2]; ++z) {
    for (int y = 0; y < size[1]; ++y) {
      constexpr int max_components = 64;
      std::uint64_t place = component + max_components * part.lattice;
      for (const auto& [edge, index] : {std::pair{n[2], at[2] + z}, {n[1], at[1] + y}, {n[0], at[0]}})
        place = place * static_cast<std::uint64_t>(edge) + static_cast<std::uint64_t>(index);
      for (int x = 0; x < size[0]; ++x) hash.add(place++, std::bit_cast<Bits>(numbers[next++]));
    }
  }
}

/// Adds the hash of the lattice to the hash of the sections. Returns the resulting hash of the checkpoint as
/// text.
std::string finish_hash(Sha256& hash, std::uint64_t lattice) {
  const std::string text = fmt::format("{}:{:016x}", lattice_name, lattice);
  hash.update(std::as_bytes(std::span(text)));
  return hash.hexadecimal();
}
/// Adds name and size [byte] of a section to the hash. The caller adds the contents of the section next.
void begin_section(Sha256& hash, const std::string& name, std::uint64_t size) {
  const std::string text = fmt::format("{}:{}:", name, size);
  hash.update(std::as_bytes(std::span(text)));
}

std::uint64_t sum_over_ranks(std::uint64_t value, const Communicator& communicator) {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_UINT64_T, MPI_SUM, communicator.get());
  return value;
}

/// Returns the extents of a dataset. Throws SolverError if the dataset does not have `dimensions` dimensions,
/// or if it declares more data than the file stores.
template <std::size_t dimensions>
std::array<hsize_t, dimensions> shape_of(const H5Handle& dataset, const std::string& what) {
  const H5Handle space(H5Dget_space(dataset), H5Sclose, what);
  std::array<hsize_t, dimensions> shape{};
  if (H5Sget_simple_extent_ndims(space) != static_cast<int>(dimensions))
    throw SolverError(what + fmt::format(": a dataset of the checkpoint has a wrong number of dimensions; "
                                         "take the run's other checkpoint (.ckpt.0 or .ckpt.1), or begin "
                                         "without {}",
                                         Setting::restart));
  H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  if (!has_plausible_extents(dataset, shape))
    throw SolverError(what + fmt::format(": a dataset of the checkpoint declares more data than the file "
                                         "contains; take the run's other checkpoint (.ckpt.0 or .ckpt.1), or "
                                         "begin without {}",
                                         Setting::restart));
  return shape;
}

/// Returns the text of an attribute. Returns an empty text if the attribute does not exist or is not a single
/// string of fixed length.
std::string attribute(const H5Handle& file, const char* name) {
  if (H5Aexists(file, name) <= 0) return "";
  const H5Handle at(H5Aopen(file, name, H5P_DEFAULT), H5Aclose, name);
  const H5Handle type(H5Aget_type(at), H5Tclose, name);
  const H5Handle space(H5Aget_space(at), H5Sclose, name);
  const bool is_one = H5Sget_simple_extent_npoints(space) == 1;
  if (!is_one || H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0) return "";
  std::string text(H5Tget_size(type), '\0');
  check_hdf5(H5Aread(at, type, text.data()), name);
  return text;
}

}  // namespace

void LatticeHash::add(std::uint64_t place, std::uint64_t bits) {
  // Mixing function of SplitMix64 (Steele, Lea and Flood 2014), applied to the bits and their index.
  std::uint64_t z = bits + place * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  value += z ^ (z >> 31);
}

CheckpointWriter::CheckpointWriter(const std::string& path, const Communicator& communicator)
    : path_(path), communicator_(communicator), file_(create_file(path, communicator)) {
  write_attribute(file_, "format", std::string(format_name));
}

CheckpointWriter::~CheckpointWriter() {
  if (is_finished_) return;
  file_.leave_open();
  if (communicator_.is_root()) unlink(part_name(path_).c_str());  // frees the disk space
}

H5Handle CheckpointWriter::create(const std::string& name, hid_t type, std::span<const hsize_t> shape) {
  const std::string what = path_ + ":/" + name;
  const H5Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose,
                       what);
  const H5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, what);
  check_hdf5(H5Pset_obj_track_times(creation, false), what);
  check_hdf5(H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER), what);
  return {H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose, what};
}

void CheckpointWriter::write_bytes(const H5Handle& dataset, hsize_t first, std::span<const char> bytes) {
  for (hsize_t done = 0; done < bytes.size();) {
    const std::array start{first + done}, count{std::min<hsize_t>(max_piece_bytes, bytes.size() - done)};
    const Selection selection = select(dataset, start, count, path_);
    if (H5Dwrite(dataset, H5T_NATIVE_CHAR, selection.memory, selection.file,
                 transfer_mode(H5FD_MPIO_INDEPENDENT, path_), bytes.data() + done) < 0)
      throw SolverError(part_name(path_) + ": the checkpoint cannot be written; is the disk full?");
    done += count[0];
  }
  hash_.update(std::as_bytes(bytes));
}

void CheckpointWriter::add(const std::string& section, std::span<const char> bytes) {
  std::uint64_t size = bytes.size();
  MPI_Bcast(&size, 1, MPI_UINT64_T, 0, communicator_.get());
  const H5Handle dataset = create(section, H5T_STD_I8LE, std::array{hsize_t(size)});
  sections_ += section + "\n";
  if (!communicator_.is_root()) return;
  begin_section(hash_, section, size);
  write_bytes(dataset, 0, bytes);
}

void CheckpointWriter::add_file(const std::string& section, const std::string& path) {
  std::uint64_t size = 0;
  std::ifstream file;
  if (communicator_.is_root()) {
    file.open(path, std::ios::binary);
    std::error_code failure;
    size = std::filesystem::file_size(path, failure);
    if (!file || failure)
      throw SolverError(
          path +
          ": the file cannot be copied into a checkpoint; was the file moved or removed during the run?");
  }
  MPI_Bcast(&size, 1, MPI_UINT64_T, 0, communicator_.get());
  const H5Handle dataset = create(section, H5T_STD_I8LE, std::array{hsize_t(size)});
  sections_ += section + "\n";
  if (!communicator_.is_root()) return;
  begin_section(hash_, section, size);
  std::vector<char> buffer(std::min<std::uint64_t>(max_piece_bytes, size));
  for (std::uint64_t done = 0; done < size;) {
    const std::uint64_t count = std::min<std::uint64_t>(buffer.size(), size - done);
    if (!file.read(buffer.data(), static_cast<std::streamsize>(count)))
      throw SolverError(
          path +
          ": the file cannot be copied into a checkpoint; was the file moved or removed during the run?");
    write_bytes(dataset, done, std::span(buffer).first(count));
    done += count;
  }
}

template <class Real>
void CheckpointWriter::add_lattice(const LatticePart& part, int components,
                                   const std::function<void(int, std::span<Real>)>& fill) {
  const H5Handle dataset = create(name_of_lattice(part.lattice), file_type<Real>(),
                                  std::array{hsize_t(components), hsize_t(part.cells[2]),
                                             hsize_t(part.cells[1]), hsize_t(part.cells[0])});
  std::vector<Real> numbers(part.size.cast<std::size_t>().prod());
  for (int c = 0; c < components; ++c) {
    fill(c, numbers);
    add_to<Real>(lattice_hash_, part, c, numbers);
    const Selection selection = select(dataset, start_of(part, c), count_of(part), path_);
    if (H5Dwrite(dataset, memory_type<Real>(), selection.memory, selection.file,
                 transfer_mode(H5FD_MPIO_COLLECTIVE, path_), numbers.data()) < 0)
      throw SolverError(part_name(path_) + ": the checkpoint cannot be written; is the disk full?");
  }
}

void CheckpointWriter::finish() {
  const std::uint64_t lattice = sum_over_ranks(lattice_hash_.value, communicator_);
  std::string hash = communicator_.is_root() ? finish_hash(hash_, lattice) : std::string(64, ' ');
  MPI_Bcast(hash.data(), static_cast<int>(hash.size()), MPI_CHAR, 0, communicator_.get());
  write_attribute(file_, "sections", sections_);
  write_attribute(file_, "content_sha256", hash);
  file_.close_checked(part_name(path_));
  MPI_Barrier(communicator_.get());
  if (communicator_.is_root()) {
    if (const int reason = name_finished_file(path_)) {
      throw SolverError(
          fmt::format("the checkpoint {} cannot be stored on the disk as {}: {}; check the disk",
                      part_name(path_), path_, std::strerror(reason)));
    }
  }
  MPI_Barrier(communicator_.get());
  is_finished_ = true;
}

CheckpointReader::CheckpointReader(const std::string& path, const Communicator& communicator)
    : path_(path), communicator_(communicator), file_(open_file(path, communicator)) {
  require_undamaged();
}

CheckpointReader::~CheckpointReader() {
  // An error may have occurred on one rank only. Closing the file would then wait for the other ranks.
  if (std::uncaught_exceptions() > exceptions_) file_.leave_open();
}

void CheckpointReader::require_undamaged() const {
  const auto require = [this](bool is_undamaged) {
    if (!all_agree(is_undamaged, communicator_))
      throw InputError(
          path_,
          fmt::format("the checkpoint is damaged: its contents do not match the stored "
                      "hash; take the run's other checkpoint (.ckpt.0 or .ckpt.1), or begin without {}",
                      Setting::restart));
  };
  std::string format, hash_on_file;
  std::uint64_t lattice = 0;
  Sha256 hash;
  bool is_read = true;
  try {
    format = attribute(file_, "format");
    if (format == format_name) {
      hash_on_file = attribute(file_, "content_sha256");
      for (int n = 0; has_lattice(n); ++n) lattice += hash_lattice_part(n);
      if (communicator_.is_root()) add_sections(hash);
    }
  } catch (const std::exception&) {  // for example unreadable data, or sizes that exceed the memory
    is_read = false;
  }
  require(is_read);
  if (!all_agree(!format.empty(), communicator_))
    throw InputError(path_,
                     "the file is an HDF5 file but not a checkpoint of Beadswim; name FILE.h5md.ckpt.0, "
                     "FILE.h5md.ckpt.1 or FILE.h5md");
  if (!all_agree(format == format_name, communicator_))
    throw InputError(path_, fmt::format("the file does not have the checkpoint format of this program, {}; "
                                        "continue with the version that wrote the file, or begin without {}",
                                        format_name, Setting::restart));
  lattice = sum_over_ranks(lattice, communicator_);
  require(!communicator_.is_root() || finish_hash(hash, lattice) == hash_on_file);
}

void CheckpointReader::add_sections(Sha256& hash) const {
  std::istringstream sections(attribute(file_, "sections"));
  for (std::string name; std::getline(sections, name);) {
    const std::uint64_t all = size(name);
    begin_section(hash, name, all);
    for (std::uint64_t done = 0; done < all;) {
      const std::vector<char> part = bytes(name, done, std::min<std::uint64_t>(max_piece_bytes, all - done));
      hash.update(std::as_bytes(std::span(part)));
      done += part.size();
    }
  }
}

bool CheckpointReader::has_lattice(int lattice) const {
  return H5Lexists(file_, name_of_lattice(lattice).c_str(), H5P_DEFAULT) > 0;
}

std::uint64_t CheckpointReader::hash_lattice_part(int lattice) const {
  const H5Handle dataset(H5Dopen2(file_, name_of_lattice(lattice).c_str(), H5P_DEFAULT), H5Dclose, path_);
  const H5Handle type(H5Dget_type(dataset), H5Tclose, path_);
  const auto shape = shape_of<4>(dataset, path_);
  const Index3 cells(static_cast<int>(shape[3]), static_cast<int>(shape[2]), static_cast<int>(shape[1]));
  const std::int64_t ranks = communicator_.size(), rank = communicator_.rank();
  const auto plane = [&](std::int64_t r) { return static_cast<int>(cells[2] * r / ranks); };
  const LatticePart part{.cells = cells,
                         .offset = {0, 0, plane(rank)},
                         .size = {cells[0], cells[1], plane(rank + 1) - plane(rank)},
                         .lattice = lattice};
  LatticeHash hash;
  const auto add_all = [&]<class Real>(Real) {
    read_lattice<Real>(part, static_cast<int>(shape[0]),
                       [&](int c, std::span<const Real> numbers) { add_to<Real>(hash, part, c, numbers); });
  };
  if (H5Tget_size(type) == sizeof(float)) {
    add_all(float{});
  } else {
    add_all(double{});
  }
  return hash.value;
}

std::uint64_t CheckpointReader::size(const std::string& section) const {
  const H5Handle dataset(H5Dopen2(file_, section.c_str(), H5P_DEFAULT), H5Dclose, path_ + ":/" + section);
  return shape_of<1>(dataset, path_ + ":/" + section)[0];
}

std::vector<char> CheckpointReader::bytes(const std::string& section, std::uint64_t first,
                                          std::uint64_t count) const {
  if (count == 0) return {};
  const H5Handle dataset(H5Dopen2(file_, section.c_str(), H5P_DEFAULT), H5Dclose, path_ + ":/" + section);
  if (first + count > shape_of<1>(dataset, path_ + ":/" + section)[0])
    throw SolverError(
        fmt::format("{}:/{}: this dataset of the checkpoint ends too early; take the run's other checkpoint "
                    "(.ckpt.0 or .ckpt.1), or begin without {}",
                    path_, section, Setting::restart));
  std::vector<char> result(count);
  const Selection selection = select(dataset, std::array{hsize_t(first)}, std::array{hsize_t(count)}, path_);
  check_hdf5(H5Dread(dataset, H5T_NATIVE_CHAR, selection.memory, selection.file,
                     transfer_mode(H5FD_MPIO_INDEPENDENT, path_), result.data()),
             path_ + ":/" + section);
  return result;
}

std::string CheckpointReader::text(const std::string& section) const {
  const std::vector<char> all = bytes(section, 0, size(section));
  return {all.begin(), all.end()};
}

void CheckpointReader::copy_to(const std::string& section, int descriptor) const {
  if (!communicator_.is_root()) return;
  const std::uint64_t all = size(section);
  const auto require = [&](bool fine) {
    if (!fine)
      throw SolverError(fmt::format("the {} that the checkpoint {} contains cannot be copied to a file: {}",
                                    section, path_, std::strerror(errno)));
  };
  require(ftruncate(descriptor, 0) == 0 && lseek(descriptor, 0, SEEK_SET) == 0);
  for (std::uint64_t done = 0; done < all;) {
    const std::vector<char> part = bytes(section, done, std::min<std::uint64_t>(max_piece_bytes, all - done));
    for (std::size_t written = 0; written < part.size();) {
      const ssize_t count = write(descriptor, part.data() + written, part.size() - written);
      if (count < 0 && errno == EINTR) continue;
      require(count >= 0);
      written += static_cast<std::size_t>(count);
    }
    done += part.size();
  }
  require(fsync(descriptor) == 0);
}

template <class Real>
void CheckpointReader::read_lattice(const LatticePart& part, int components,
                                    const std::function<void(int, std::span<const Real>)>& take) const {
  const H5Handle dataset(H5Dopen2(file_, name_of_lattice(part.lattice).c_str(), H5P_DEFAULT), H5Dclose,
                         path_);
  const std::array wanted{hsize_t(components), hsize_t(part.cells[2]), hsize_t(part.cells[1]),
                          hsize_t(part.cells[0])};
  if (shape_of<4>(dataset, path_) != wanted)
    throw SolverError(path_ +
                      fmt::format(": the lattice in the checkpoint has other dimensions than the lattice of "
                                  "this run; take the run's other checkpoint (.ckpt.0 or .ckpt.1), or "
                                  "begin without {}",
                                  Setting::restart));
  std::vector<Real> numbers(part.size.cast<std::size_t>().prod());
  for (int c = 0; c < components; ++c) {
    if (!numbers.empty()) {
      const Selection selection = select(dataset, start_of(part, c), count_of(part), path_);
      check_hdf5(H5Dread(dataset, memory_type<Real>(), selection.memory, selection.file,
                         transfer_mode(H5FD_MPIO_INDEPENDENT, path_), numbers.data()),
                 path_);
    }
    take(c, numbers);
  }
}

template void CheckpointWriter::add_lattice<float>(const LatticePart&, int,
                                                   const std::function<void(int, std::span<float>)>&);
template void CheckpointWriter::add_lattice<double>(const LatticePart&, int,
                                                    const std::function<void(int, std::span<double>)>&);
template void CheckpointReader::read_lattice<float>(
    const LatticePart&, int, const std::function<void(int, std::span<const float>)>&) const;
template void CheckpointReader::read_lattice<double>(
    const LatticePart&, int, const std::function<void(int, std::span<const double>)>&) const;

}  // namespace beadswim
