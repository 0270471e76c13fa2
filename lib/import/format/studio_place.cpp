#include "import/format/studio_place.h"

#include <algorithm>
#include <iterator>

namespace obby::importer {
namespace {

constexpr const char* kPlace = "ObbyPlace";
constexpr std::string_view kPlayerServices[] = {
    "Workspace",     "StarterPlayer", "ServerScriptService", "StarterGui", "ReplicatedFirst",
    "ServerStorage", "Teams"};
// Children of StarterPlayer that the plugin sends as a Folder of that name.
constexpr std::string_view kContainers[] = {"StarterPlayerScripts", "StarterCharacterScripts"};

bool isServiceStandIn(const Instance& instance) {
  const bool known = std::find(std::begin(kPlayerServices), std::end(kPlayerServices),
                               instance.name) != std::end(kPlayerServices);
  return known && instance.className == "Configuration";
}

void becomeService(Instance& instance) {
  instance.className = instance.name;
  for (auto& [name, value] : instance.attributes) instance.properties[name] = std::move(value);
  instance.attributes.clear();
  instance.parent = kNoInstance;
}

void unpackContainers(std::vector<Instance>& all, const Instance& player) {
  for (const InstanceId id : player.children) {
    const bool known = std::find(std::begin(kContainers), std::end(kContainers), all[id].name) !=
                       std::end(kContainers);
    if (known && all[id].className == "Folder") all[id].className = all[id].name;
  }
}

}  // namespace

void unpackStudioPlace(Document& document) {
  auto& all = document.instances;
  const auto place = std::find_if(document.roots.begin(), document.roots.end(), [&](InstanceId id) {
    return all[id].name == kPlace && all[id].className == "Configuration";
  });
  if (place == document.roots.end()) return;
  std::vector<InstanceId> services, kept;
  for (const InstanceId id : all[*place].children) {
    (isServiceStandIn(all[id]) ? services : kept).push_back(id);
  }
  const auto workspace = std::find_if(services.begin(), services.end(),
                                      [&](InstanceId id) { return all[id].name == "Workspace"; });
  if (workspace == services.end()) return;
  all[*place].children = std::move(kept);
  for (const InstanceId id : services) {
    becomeService(all[id]);
    if (all[id].className == "StarterPlayer") unpackContainers(all, all[id]);
  }
  for (const InstanceId id : document.roots) {
    if (id == *place) continue;
    all[id].parent = *workspace;
    all[*workspace].children.push_back(id);
  }
  services.push_back(*place);  // `place` points into the roots
  document.roots = std::move(services);
}

}  // namespace obby::importer
