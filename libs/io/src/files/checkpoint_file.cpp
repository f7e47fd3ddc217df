#include "beadswim/io/checkpoint_file.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <optional>
#include <sstream>
#include <type_traits>

#include "beadswim/core/error.hpp"
#include "beadswim/core/keyed_random.hpp"
#include "beadswim/core/setting.hpp"
#include "part_file.hpp"

namespace beadswim {
namespace {

constexpr const char* format_name = "beadswim/checkpoint/1";
constexpr const char* format_page = "docs/formats/checkpoint.md";
constexpr const char* other_file = "name FILE.h5md.ckpt.0, FILE.h5md.ckpt.1 or FILE.h5md";
constexpr std::uint64_t max_piece_bytes = std::uint64_t{1} << 26;  ///< of a read or write operation

std::string other_checkpoint() {
  return fmt::format("; take the run's other checkpoint (.ckpt.0 or .ckpt.1), or begin without {}",
                     Setting::restart);
}

/// Returns the name of the dataset of a lattice: lattice, lattice1, lattice2, ...
std::string name_of_lattice(int lattice) {
  return lattice == 0 ? "lattice" : fmt::format("lattice{}", lattice);
}

/// Returns true on all ranks if `yes` is true on all ranks. Collective.
bool all_agree(bool yes, const Communicator& communicator) {
  int all = yes ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &all, 1, MPI_INT, MPI_MIN, communicator.get());
  return all == 1;
}

/// Throws InputError on all ranks if `is_fine` is false on any rank. Collective.
void require_on_all_ranks(bool is_fine, const std::string& path, const std::string& fault,
                          const Communicator& communicator) {
  if (!all_agree(is_fine, communicator)) throw InputError(path, fault);
}

H5File open_file(const std::string& path, const Communicator& communicator) {
  // Rank 0 first checks that the file exists and is an HDF5 file, before all ranks open it in parallel.
  require_on_all_ranks(!communicator.is_root() || H5Fis_hdf5(path.c_str()) > 0, path,
                       fmt::format("the file is not a checkpoint, or cannot be read; {}", other_file),
                       communicator);
  std::optional<H5File> file;
  try {
    file.emplace(path, H5File::Mode::read, format_page, &communicator);
  } catch (const DataError&) {  // all ranks throw below
  }
  if (all_agree(file.has_value(), communicator)) return std::move(*file);
  if (file) file->leave_open();
  throw InputError(path, "the file is not a checkpoint, or is damaged" + other_checkpoint());
}

/// Extents of a lattice, with the components as slowest and x as fastest index.
Extents extents_of(int components, const Index3& cells) {
  return {hsize_t(components), hsize_t(cells[2]), hsize_t(cells[1]), hsize_t(cells[0])};
}

/// One component of a part of a lattice in the dataset of the lattice.
Hyperslab place_of(const LatticePart& part, int component) {
  return {.start = extents_of(component, part.offset), .count = extents_of(1, part.size)};
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

void add_text(Sha256& hash, const std::string& text) {
  hash.update(std::as_bytes(std::span(text)));
}

/// Adds the hash of the lattices to the hash of the sections. Returns the resulting hash of the checkpoint as
/// text.
std::string finish_hash(Sha256& hash, std::uint64_t lattices) {
  add_text(hash, fmt::format("lattice:{:016x}", lattices));
  return hash.hexadecimal();
}

std::uint64_t sum_over_ranks(std::uint64_t value, const Communicator& communicator) {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_UINT64_T, MPI_SUM, communicator.get());
  return value;
}

/// Calls handle(first, count) for consecutive pieces of `size` bytes.
void for_each_piece(std::uint64_t size, auto&& handle) {
  for (std::uint64_t first = 0; first < size; first += max_piece_bytes)
    handle(first, std::min(max_piece_bytes, size - first));
}

}  // namespace

void LatticeHash::add(std::uint64_t place, std::uint64_t bits) {
  value += mix_bits(bits + place * golden_gamma);
}

void with_checkpoint_remedy(const std::function<void()>& read) {
  try {
    read();
  } catch (const DataError& fault) {
    throw SolverError(fault.what() + other_checkpoint());
  }
}

CheckpointWriter::CheckpointWriter(const std::string& path, const Communicator& communicator)
    : path_(path),
      communicator_(communicator),
      file_(part_name(path), H5File::Mode::create, format_page, &communicator) {
  file_.write_attribute("/", "format", std::string(format_name));
}

CheckpointWriter::~CheckpointWriter() {
  if (is_finished_) return;
  file_.leave_open();
  if (communicator_.is_root()) unlink(part_name(path_).c_str());  // frees the disk space
}

void CheckpointWriter::add_pieces(const std::string& section, std::uint64_t size, const Piece& piece) {
  MPI_Bcast(&size, 1, MPI_UINT64_T, 0, communicator_.get());
  const H5Dataset dataset = file_.create(section, number_type<char>(), {size});
  sections_ += section + "\n";
  if (!communicator_.is_root()) return;
  add_text(hash_, fmt::format("{}:{}:", section, size));
  for_each_piece(size, [&](std::uint64_t first, std::uint64_t count) {
    const std::span<const char> bytes = piece(first, count);
    dataset.write({{first}, {count}}, bytes.data());
    hash_.update(std::as_bytes(bytes));
  });
}

void CheckpointWriter::add(const std::string& section, std::span<const char> bytes) {
  add_pieces(section, bytes.size(),
             [&](std::uint64_t first, std::uint64_t count) { return bytes.subspan(first, count); });
}

void CheckpointWriter::add_file(const std::string& section, std::FILE* file) {
  const auto require = [&](bool is_read) {
    if (!is_read)
      throw SolverError(fmt::format("the {} cannot be copied into the checkpoint {}: {}", section, path_,
                                    std::strerror(errno)));
  };
  std::int64_t size = 0;
  if (communicator_.is_root()) {
    require(std::fseek(file, 0, SEEK_END) == 0 && (size = std::ftell(file)) >= 0);
    std::rewind(file);
  }
  std::vector<char> buffer;
  add_pieces(section, size, [&](std::uint64_t, std::uint64_t count) {
    buffer.resize(count);
    require(std::fread(buffer.data(), 1, count, file) == count);
    return std::span<const char>(buffer);
  });
}

template <class Real>
void CheckpointWriter::add_lattice(const LatticePart& part, int components,
                                   const std::function<void(int, std::span<Real>)>& fill) {
  const H5Dataset dataset =
      file_.create(name_of_lattice(part.lattice), number_type<Real>(), extents_of(components, part.cells));
  std::vector<Real> numbers(part.size.cast<std::size_t>().prod());
  for (int c = 0; c < components; ++c) {
    fill(c, numbers);
    add_to<Real>(lattice_hash_, part, c, numbers);
    dataset.write(place_of(part, c), numbers.data(), Transfer::collective);
  }
}

void CheckpointWriter::finish() {
  const std::uint64_t lattices = sum_over_ranks(lattice_hash_.value, communicator_);
  std::string hash = communicator_.is_root() ? finish_hash(hash_, lattices) : "";
  broadcast(hash, communicator_);
  file_.write_attribute("/", "sections", sections_);
  file_.write_attribute("/", "content_sha256", hash);
  file_.close_checked();
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
  const std::string format = attribute("format");
  std::uint64_t lattices = 0;
  Sha256 hash;
  bool is_read = true;
  try {
    for (int n = 0; format == format_name && file_.contains(name_of_lattice(n)); ++n)
      lattices += hash_lattice_part(n);
    if (format == format_name && communicator_.is_root()) add_sections(hash);
  } catch (const std::exception&) {  // for example unreadable data, or sizes that exceed the memory
    is_read = false;
  }
  const auto require = [this](bool is_fine, const std::string& fault) {
    require_on_all_ranks(is_fine, path_, fault, communicator_);
  };
  const std::string damaged =
      "the checkpoint is damaged: its contents do not match the stored hash" + other_checkpoint();
  require(is_read, damaged);
  require(!format.empty(),
          fmt::format("the file is an HDF5 file but not a checkpoint of Beadswim; {}", other_file));
  require(format == format_name,
          fmt::format("the file does not have the checkpoint format of this program, {}; continue with the "
                      "version that wrote the file, or begin without {}",
                      format_name, Setting::restart));
  lattices = sum_over_ranks(lattices, communicator_);
  require(!communicator_.is_root() || finish_hash(hash, lattices) == attribute("content_sha256"), damaged);
}

std::string CheckpointReader::attribute(const std::string& name) const {
  try {
    return file_.read_attribute("/", name).front();
  } catch (const DataError&) {
    return "";
  }
}

void CheckpointReader::add_sections(Sha256& hash) const {
  std::istringstream sections(attribute("sections"));
  for (std::string name; std::getline(sections, name);) {
    const std::uint64_t all = size(name);
    add_text(hash, fmt::format("{}:{}:", name, all));
    for_each_piece(all, [&](std::uint64_t first, std::uint64_t count) {
      const std::vector<char> piece = bytes(name, first, count);
      hash.update(std::as_bytes(std::span(piece)));
    });
  }
}

H5Dataset CheckpointReader::open_lattice(int lattice) const {
  return file_.open(name_of_lattice(lattice), Extents(4, any_extent));
}

std::uint64_t CheckpointReader::hash_lattice_part(int lattice) const {
  const H5Dataset dataset = open_lattice(lattice);
  const Extents& extents = dataset.extents();
  const Index3 cells(static_cast<int>(extents[3]), static_cast<int>(extents[2]),
                     static_cast<int>(extents[1]));
  const auto [first, end] = rank_share(cells[2], communicator_.rank(), communicator_.size());
  const LatticePart part{.cells = cells,
                         .offset = {0, 0, static_cast<int>(first)},
                         .size = {cells[0], cells[1], static_cast<int>(end - first)},
                         .lattice = lattice};
  LatticeHash hash;
  const auto add_all = [&]<class Real>(Real) {
    read_lattice<Real>(part, static_cast<int>(extents[0]),
                       [&](int c, std::span<const Real> numbers) { add_to<Real>(hash, part, c, numbers); });
  };
  if (dataset.bytes_per_number() == sizeof(float)) {
    add_all(float{});
  } else {
    add_all(double{});
  }
  return hash.value;
}

std::uint64_t CheckpointReader::size(const std::string& section) const {
  return file_.open(section, {any_extent}).extents()[0];
}

std::vector<char> CheckpointReader::bytes(const std::string& section, std::uint64_t first,
                                          std::uint64_t count) const {
  return file_.open(section, {any_extent}).read_rows<char>(first, count);
}

std::string CheckpointReader::text(const std::string& section) const {
  const std::vector<char> all = bytes(section);
  return {all.begin(), all.end()};
}

void CheckpointReader::copy_to(const std::string& section, std::FILE* file) const {
  if (!communicator_.is_root()) return;
  const auto require = [&](bool is_written) {
    if (!is_written)
      throw SolverError(fmt::format("the {} that the checkpoint {} contains cannot be copied to a file: {}",
                                    section, path_, std::strerror(errno)));
  };
  std::rewind(file);
  require(ftruncate(fileno(file), 0) == 0);
  for_each_piece(size(section), [&](std::uint64_t first, std::uint64_t count) {
    require(std::fwrite(bytes(section, first, count).data(), 1, count, file) == count);
  });
  require(std::fflush(file) == 0 && fsync(fileno(file)) == 0);
}

template <class Real>
void CheckpointReader::read_lattice(const LatticePart& part, int components,
                                    const std::function<void(int, std::span<const Real>)>& take) const {
  const H5Dataset dataset = open_lattice(part.lattice);
  if (dataset.extents() != extents_of(components, part.cells))
    throw DataError(path_, "the lattice in the checkpoint has other dimensions than the lattice of this run");
  std::vector<Real> numbers(part.size.cast<std::size_t>().prod());
  for (int c = 0; c < components; ++c) {
    dataset.read(place_of(part, c), numbers.data());
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
