// What a server sets gets to all clients; what a client sets stays there.
#include "import/luau/changes.h"

namespace obby::importer::luau {

void Changes::add(const Keys& keys, InstanceId script, bool onClient) {
  Setters& setters = onClient ? client_ : server_;
  for (const Key& key : keys) {
    const auto [setter, isNew] = setters.try_emplace(key, script);
    if (!isNew && setter->second != script) setter->second = kNoInstance;
  }
}

bool Changes::reach(const Key& key, InstanceId script, bool onClient) const {
  const auto sets = [&](const Setters& setters) {
    const auto setter = setters.find(key);
    return setter != setters.end() && setter->second != script;
  };
  return sets(server_) || (onClient && sets(client_));
}

}  // namespace obby::importer::luau
