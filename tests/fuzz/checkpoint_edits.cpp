#include "checkpoint_edits.hpp"

#include <algorithm>
#include <limits>

namespace beadswim {
namespace {

/// Returns a random position in a text of this size.
std::size_t place_in(std::size_t size, ByteSource& edits) {
  return edits.take<std::uint32_t>() % (size + 1);
}

void edit_section(std::vector<CheckpointContents::Section>& sections, ByteSource& edits) {
  const std::size_t which = edits.choice(sections.size());
  std::string& bytes = sections[which].bytes;
  switch (edits.choice(5)) {
    case 0:
      sections.erase(sections.begin() + static_cast<std::ptrdiff_t>(which));
      break;
    case 1:
      bytes = edits.text(edits.choice(256));
      break;
    case 2:
      bytes.resize(place_in(bytes.size(), edits));
      break;
    case 3:
      bytes.insert(place_in(bytes.size(), edits), edits.text(edits.choice(16)));
      break;
    default: {
      const std::size_t at = place_in(bytes.size(), edits);
      const std::string changed = edits.text(std::min(edits.choice(16), bytes.size() - at));
      std::ranges::copy(changed, bytes.begin() + static_cast<std::ptrdiff_t>(at));
    }
  }
}

void edit_lattice(CheckpointContents& contents, ByteSource& edits) {
  constexpr std::array odd{std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -1.0, 1e300, 0.0};
  const auto resize = [&] {
    contents.numbers.resize(contents.components * contents.cells.cast<std::size_t>().prod());
  };
  switch (edits.choice(3)) {
    case 0:
      contents.cells[static_cast<int>(edits.choice(3))] = 1 + static_cast<int>(edits.choice(40));
      resize();
      break;
    case 1:
      contents.components = static_cast<int>(edits.choice(21));
      resize();
      break;
    default:
      if (!contents.numbers.empty())
        contents.numbers[edits.take<std::uint32_t>() % contents.numbers.size()] =
            odd[edits.choice(odd.size())];
  }
}

}  // namespace

void CheckpointContents::read(const CheckpointReader& checkpoint) {
  for (Section& section : sections) section.bytes = checkpoint.text(section.name);
  if (components == 0) return;
  checkpoint.read_lattice<double>({.cells = cells, .offset = Index3::Zero(), .size = cells}, components,
                                  [&](int, std::span<const double> component) {
                                    numbers.insert(numbers.end(), component.begin(), component.end());
                                  });
}

void CheckpointContents::write(const std::string& path, const Communicator& communicator) const {
  CheckpointWriter writer(path, communicator);
  for (const auto& [name, bytes] : sections) writer.add(name, bytes);
  if (components > 0) {
    auto next = numbers.begin();
    writer.add_lattice<double>({.cells = cells, .offset = Index3::Zero(), .size = cells}, components,
                               [&](int, std::span<double> component) {
                                 std::copy_n(next, component.size(), component.begin());
                                 next += std::ssize(component);
                               });
  }
  writer.finish();
}

void CheckpointContents::edit(ByteSource& edits) {
  while (!edits.is_at_end()) {
    if (components > 0 && edits.choice(4) == 0) {
      edit_lattice(*this, edits);
    } else if (!sections.empty()) {
      edit_section(sections, edits);
    } else {
      return;
    }
  }
}

}  // namespace beadswim
