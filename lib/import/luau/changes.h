// What the scripts of a place set to something else than the file has: by the time of a touch one
// script may find what another one has set, as of a lever in one and its trap in the other.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "engine/document.h"

namespace obby::importer::luau {

// An instance and the name of a property, or "@" and that of an attribute.
using Key = std::pair<InstanceId, std::string>;
using Keys = std::set<Key>;

// The most that is kept of what the scripts of a place set, and as many again of what they ask for:
// 20 to 50 MB each. One that sets ten properties of 20,000 parts has fewer; a crafted one would
// have as many as it has steps.
constexpr size_t kMaxKeys = 250000;
// "@" and the 100 characters that the engine allows the name of an attribute: a longer one names
// nothing that a script could set.
constexpr size_t kLongestKey = 101;

class Changes {
 public:
  // Of one script. `onClient`: it runs for a player, and the scripts of the server find nothing of
  // what it sets. False if there was no room for all.
  [[nodiscard]] bool add(const Keys& keys, InstanceId script, bool onClient);
  // Whether a script, of the client or not, may find what another one has set.
  bool reach(const Key& key, InstanceId script, bool onClient) const;

 private:
  // By which script it is set; kNoInstance: by several.
  using Setters = std::map<Key, InstanceId>;
  Setters server_, client_;  // kMaxKeys together
};

}  // namespace obby::importer::luau
