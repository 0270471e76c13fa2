// Reads motions that were recorded in the running game. The attribute ObbyMotion, which the Studio
// plugin writes, holds the schema's Motion as JSON. It overrides evidence from scripts.
#include <fmt/format.h>

#include "import/draft/motion.h"
#include "import/roles/role.h"
#include "io/json_codec.h"
#include "io/text.h"
#include "level/record_values.h"

namespace obby::importer {
namespace {

constexpr const char* kAttribute = "ObbyMotion";

Pose poseOf(schema::MotionKey::Reader key) {
  const auto q = key.getRotation();
  return {level::vec(key.getPosition()),
          toMat3(normalize(Quat{q.getX(), q.getY(), q.getZ(), q.getW()}))};
}

Motion motionOf(schema::Motion::Reader record) {
  Motion motion;
  for (const auto key : record.getKeys()) {
    motion.keys.push_back(
        {key.getTime(), poseOf(key), Easing(key.getEasing()), EasingDirection(key.getDirection())});
  }
  motion.repeat = Repeat(record.getRepeat());
  if (record.hasSpin()) {
    const auto spin = record.getSpin();
    motion.spin = {level::vec(spin.getAxis()), spin.getSpeed(), level::vec(spin.getPivot())};
  }
  motion.offset = record.getOffset();
  motion.carries = record.getCarries();
  return motion;
}

bool moves(schema::Motion::Reader record) {
  return record.getKeys().size() > 0 || record.hasSpin();
}

void give(RoleContext& context, PartDraft& part, const std::string& text) {
  const auto read =
      io::recordFromJson(fmt::format("{{\"type\":\"level\",\"parts\":[{{\"motion\":{}}}]}}", text));
  const bool whole = read && read->reader().isLevel() &&
                     read->reader().getLevel().getParts().size() == 1 &&
                     moves(read->reader().getLevel().getParts()[0].getMotion());
  if (!whole) {
    context.level.noteUnmodelled(
        "recorded motion", context.tree, part.id,
        read ? "the attribute ObbyMotion has neither keys nor a spin; record it again"
             : read.error().text());
    return;
  }
  const auto record = read->reader().getLevel().getParts()[0].getMotion();
  giveMotion(context, part.id, motionOf(record),
             fmt::format("attribute {}: {}{} recorded in the game", kAttribute,
                         io::plural(record.getKeys().size(), "pose"),
                         record.hasSpin() ? " and a spin" : ""),
             false);
}

}  // namespace

void movingFromRecordings(RoleContext& context) {
  for (InstanceId id = 0; id < context.tree.size(); ++id) {
    const auto& attributes = context.tree.at(id).attributes;
    const auto found = attributes.find(kAttribute);
    PartDraft* part = found == attributes.end() ? nullptr : context.part(id);
    const auto* text = part ? std::get_if<std::string>(&found->second) : nullptr;
    if (text) give(context, *part, *text);
  }
}

}  // namespace obby::importer
