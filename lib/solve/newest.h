// A cache of values by key, within a memory budget. A stream need not end, so only the newest
// values that fit are kept. The newest is kept whatever its size.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"

namespace obby::solve {

template <class Key, class Value>
class Newest {
 public:
  // `maxBytes`: memory budget of the kept values.
  explicit Newest(uint64_t maxBytes) : maxBytes_(maxBytes) {}

  // Adds a value as the newest. It replaces a value with the same key. Returns the keys of the
  // values dropped to make space, oldest first.
  std::vector<Key> add(Key key, Value value, uint64_t bytes) {
    forget(key);
    bytes_ += bytes;
    byAge_.emplace(added_, key);
    kept_.emplace(std::move(key), Kept{std::move(value), bytes, added_++});
    std::vector<Key> dropped;
    while (bytes_ > maxBytes_ && kept_.size() > 1) {
      dropped.push_back(byAge_.begin()->second);
      forget(dropped.back());
    }
    dropped_ += dropped.size();
    return dropped;
  }

  // Returns null if the key has no value.
  const Value* find(const Key& key) const {
    const auto found = kept_.find(key);
    return found == kept_.end() ? nullptr : &found->second.value;
  }

  // Updates the memory of a value that has grown.
  void weigh(const Key& key, uint64_t bytes) {
    Kept& kept = kept_.at(key);
    bytes_ += bytes - kept.bytes;
    kept.bytes = bytes;
  }

  void forget(const Key& key) {
    if (const auto found = kept_.find(key); found != kept_.end()) erase(found);
  }

  // Forgets the values of `first` and of the keys after it, up to the first key that is not
  // `alike`.
  void forgetFrom(const Key& first, const auto& alike) {
    auto at = kept_.lower_bound(first);
    while (at != kept_.end() && alike(at->first)) at = erase(at);
  }

  // Adds to an error about a missing key that its value may have been dropped. The keys of dropped
  // values are not kept, since their number would grow without bound. `order` says how to avoid
  // that, as in "put a after b"; `many` names the values.
  Error explained(Error missing, const char* order, const char* many) const {
    if (dropped_ == 0) return missing;
    missing.message += fmt::format(", or it is one of {} that were dropped from memory", dropped_);
    missing.hint =
        fmt::format("{}; only the newest {} are kept, up to {} MiB", order, many, maxBytes_ >> 20);
    return missing;
  }

 private:
  struct Kept {
    Value value;
    uint64_t bytes, number;
  };

  auto erase(typename std::map<Key, Kept>::iterator kept) {
    bytes_ -= kept->second.bytes;
    byAge_.erase(kept->second.number);
    return kept_.erase(kept);
  }

  const uint64_t maxBytes_;
  std::map<Key, Kept> kept_;
  std::map<uint64_t, Key> byAge_;     // oldest first
  uint64_t bytes_ = 0;                // total size of the kept values
  uint64_t added_ = 0, dropped_ = 0;  // so far
};

}  // namespace obby::solve
