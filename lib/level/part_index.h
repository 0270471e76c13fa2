// Finds the parts of a level by the texts that name them. A query may list as many names as the
// level has parts; a pass over all parts for each name would take minutes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "schema/obby.capnp.h"

namespace obby::level {

// Returns a part's path, or its name if it has none. Valid while the record lives.
std::string_view pathOf(schema::Part::Reader part);

// Results are in the level's order, each part once, and empty if no part fits. The first few texts
// are looked up in passes over all parts; after that the texts are sorted once. Not thread-safe.
class PartIndex {
 public:
  // The record must outlive this object.
  explicit PartIndex(schema::Level::Reader level) : level_(level) {}

  schema::Level::Reader level() const { return level_; }

  std::vector<uint32_t> withGuid(std::string_view guid);
  std::vector<uint32_t> withPath(std::string_view path);  // the whole path
  std::vector<uint32_t> withName(std::string_view name);
  std::vector<uint32_t> withPathEnd(std::string_view end);  // the path after any of its slashes
  std::vector<uint32_t> withTag(std::string_view tag);

 private:
  struct Entry {
    std::string_view text;
    uint32_t part;
  };
  struct Table {
    size_t asked = 0;
    std::vector<Entry> entries;  // sorted by the ends of their texts; empty until sorting pays off
  };

  // Returns the parts with a text that fits. `texts` calls its second argument with each text of a
  // part.
  template <class Texts>
  std::vector<uint32_t> find(Table& table, std::string_view text, bool atEnd, const Texts& texts);

  schema::Level::Reader level_;
  Table guids_, paths_, names_, tags_;
};

}  // namespace obby::level
