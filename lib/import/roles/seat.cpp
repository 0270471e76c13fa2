// Finds seats that hold a player who touches them. Seats of vehicles are excluded.
#include "engine/classes/class_defaults.h"
#include "import/roles/role.h"

namespace obby::importer {

void seatFromClass(RoleContext& context) {
  for (PartDraft& part : context.level.parts) {
    const Instance& instance = context.tree.at(part.id);
    if (instance.className != "Seat" || get<bool>(instance, "Disabled")) continue;
    part.seat = true;
    part.evidence.push_back({"seat", "class Seat", false});
  }
}

}  // namespace obby::importer
