// Lists the roles and the order of evidence.
#include "import/roles/role.h"

namespace obby::importer {
namespace {

//   role                tags, class           markers              other evidence
constexpr RoleRow kRoles[] = {
    {"goal", goalFromTags, nullptr, goalFromNames},
    {"checkpoint", checkpointFromTags, checkpointFromMarkers, checkpointFromNames},
    {"kill", killFromTags, killFromMarkers, killFromNames},
    {"jumpPad", jumpPadFromTags, jumpPadFromMarkers, nullptr},
    {"boost", nullptr, boostFromMarkers, nullptr},
    {"oneWay", oneWayFromTags, oneWayFromMarkers, nullptr},
    {"conveyor", conveyorFromTags, conveyorFromMarkers, conveyorFromVelocity},
    {"vanish", vanishFromTags, vanishFromMarkers, nullptr},
    {"seat", seatFromClass, nullptr, nullptr},
    {"ladder", nullptr, nullptr, ladderFromStacks},
    {"motion", movingFromTags, movingFromMarkers, movingFromConstraints},
};

}  // namespace

std::string markerWords(const Tree& tree, InstanceId marker) {
  std::string words = lower(tree.at(marker).name);
  for (const auto& tag : tree.at(marker).tags) words += ' ' + lower(tag);
  return words;
}

void findRoles(RoleContext& context) {
  for (const RoleFinder RoleRow::*finder :
       {&RoleRow::fromTags, &RoleRow::fromMarkers, &RoleRow::fromNames})
    for (const RoleRow& role : kRoles)
      if (role.*finder) (role.*finder)(context);
}

}  // namespace obby::importer
