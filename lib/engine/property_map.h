// The properties of one instance as a small map in a sorted array. Places hold millions of
// properties, and a node each would cost more than the values.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace obby {

// Iterates in order of the names. Pointers and iterators last until the next insertion.
template <class Value>
class PropertyMap {
 public:
  using value_type = std::pair<std::string, Value>;
  using iterator = typename std::vector<value_type>::iterator;
  using const_iterator = typename std::vector<value_type>::const_iterator;

  const_iterator begin() const { return entries_.begin(); }
  const_iterator end() const { return entries_.end(); }
  iterator begin() { return entries_.begin(); }
  iterator end() { return entries_.end(); }
  size_t size() const { return entries_.size(); }
  bool empty() const { return entries_.empty(); }

  const_iterator find(std::string_view name) const {
    const auto at = std::lower_bound(entries_.begin(), entries_.end(), name, before);
    return at != entries_.end() && at->first == name ? at : entries_.end();
  }
  bool contains(std::string_view name) const { return find(name) != end(); }
  size_t count(std::string_view name) const { return contains(name) ? 1 : 0; }

  // Returns the value under `name`, which is added if absent.
  Value& operator[](std::string_view name) {
    auto at = std::lower_bound(entries_.begin(), entries_.end(), name, before);
    if (at == entries_.end() || at->first != name) {
      at = entries_.emplace(at, std::string(name), Value{});
    }
    return at->second;
  }

  // Releases unused capacity.
  void compact() { entries_.shrink_to_fit(); }

 private:
  static bool before(const value_type& entry, std::string_view name) { return entry.first < name; }

  std::vector<value_type> entries_;
};

}  // namespace obby
