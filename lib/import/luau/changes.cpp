// What a server sets gets to all clients; what a client sets stays there.
#include "import/luau/changes.h"

namespace obby::importer::luau {

bool Changes::add(const Keys& keys, InstanceId script, bool onClient) {
  Setters& setters = onClient ? client_ : server_;
  bool all = true;
  for (const Key& key : keys) {
    const bool room = server_.size() + client_.size() < kMaxKeys;
    const auto known = setters.find(key);
    if (known != setters.end()) {
      if (known->second != script) known->second = kNoInstance;
    } else if (room) {
      setters.emplace(key, script);
    } else {
      all = false;
    }
  }
  return all;
}

bool Changes::reach(const Key& key, InstanceId script, bool onClient) const {
  const auto sets = [&](const Setters& setters) {
    const auto setter = setters.find(key);
    return setter != setters.end() && setter->second != script;
  };
  return sets(server_) || (onClient && sets(client_));
}

}  // namespace obby::importer::luau
