// Finds platforms that a player can jump through from below: by tag or kit marker.
#include "import/roles/role.h"

namespace obby::importer {
namespace {

const std::vector<std::string_view> kOneWayTags = {"onewayplatform", "oneway", "one way"};

void give(PartDraft& part, std::string reason) {
  if (part.oneWay || !part.solid) return;
  part.oneWay = true;
  part.evidence.push_back({"oneWay", std::move(reason), false});
}

}  // namespace

void oneWayFromTags(RoleContext& context) {
  context.eachTagged(kOneWayTags, [&](InstanceId id, const std::string& tag) {
    for (PartDraft* part : context.partsOf(id)) give(*part, "tag " + tag);
  });
}

void oneWayFromMarkers(RoleContext& context) {
  context.eachMarker([&](InstanceId marker, InstanceId owner) {
    if (!containsWord(markerWords(context.tree, marker), "onewayplatform")) return;
    for (PartDraft* part : context.partsOf(owner))
      give(*part, "marker " + context.tree.at(marker).name);
  });
}

}  // namespace obby::importer
