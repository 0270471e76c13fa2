#include "level/part_index.h"

#include <algorithm>
#include <string>

namespace obby::level {
namespace {

// Max passes over all parts before sorting. They take about as long as sorting the parts.
constexpr size_t kMaxPasses = 16;

std::string_view view(capnp::Text::Reader text) { return {text.cStr(), text.size()}; }

// Compares texts backwards, so that texts with the same end become neighbours.
bool isBefore(std::string_view a, std::string_view b) {
  return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
}

}  // namespace

std::string_view pathOf(schema::Part::Reader part) {
  const std::string_view path = view(part.getSource().getPath());
  return path.empty() ? view(part.getName()) : path;
}

template <class Texts>
std::vector<uint32_t> PartIndex::find(Table& table, std::string_view text, bool atEnd,
                                      const Texts& texts) {
  const auto fits = [&](std::string_view other) {
    return atEnd ? other.ends_with(text) : other == text;
  };
  const auto forEach = [&](const auto& use) {
    uint32_t i = 0;
    for (const auto part : level_.getParts()) {
      texts(part, [&](std::string_view other) { use(Entry{other, i}); });
      ++i;
    }
  };
  std::vector<uint32_t> found;
  if (++table.asked <= kMaxPasses) {
    forEach([&](const Entry& e) {
      if (fits(e.text)) found.push_back(e.part);
    });
  } else {
    if (table.entries.empty()) {
      forEach([&](const Entry& e) { table.entries.push_back(e); });
      std::stable_sort(table.entries.begin(), table.entries.end(),
                       [](const Entry& a, const Entry& b) { return isBefore(a.text, b.text); });
    }
    auto it =
        std::lower_bound(table.entries.begin(), table.entries.end(), text,
                         [](const Entry& e, std::string_view t) { return isBefore(e.text, t); });
    for (; it != table.entries.end() && fits(it->text); ++it) found.push_back(it->part);
    std::sort(found.begin(), found.end());  // different texts may have the same end
  }
  found.erase(std::unique(found.begin(), found.end()), found.end());  // a tag may be given twice
  return found;
}

std::vector<uint32_t> PartIndex::withGuid(std::string_view guid) {
  return find(guids_, guid, false,
              [](auto part, const auto& use) { use(view(part.getSource().getGuid())); });
}

std::vector<uint32_t> PartIndex::withPath(std::string_view path) {
  return find(paths_, path, false, [](auto part, const auto& use) { use(pathOf(part)); });
}

std::vector<uint32_t> PartIndex::withName(std::string_view name) {
  return find(names_, name, false, [](auto part, const auto& use) { use(view(part.getName())); });
}

std::vector<uint32_t> PartIndex::withPathEnd(std::string_view end) {
  return find(paths_, "/" + std::string(end), true,
              [](auto part, const auto& use) { use(pathOf(part)); });
}

std::vector<uint32_t> PartIndex::withTag(std::string_view tag) {
  return find(tags_, tag, false, [](auto part, const auto& use) {
    for (const auto t : part.getTags()) use(view(t));
  });
}

}  // namespace obby::level
