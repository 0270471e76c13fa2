// Compares parts with what the file had: what a script sets back has not changed.
#include "import/part_changes.h"

#include <fmt/format.h>

#include <utility>

#include "import/hulls.h"
#include "import/motion.h"
#include "import/pose_math.h"

namespace obby::importer {
namespace {

// Corners are in studs, too.
void resizeHulls(PartDraft& part, Vec3 before) {
  const Vec3 old = boundedSize(before);
  const size_t count = part.hulls.size();
  part.hulls = scaledHulls(std::move(part.hulls),
                           {part.size.x / old.x, part.size.y / old.y, part.size.z / old.z});
  if (part.hulls.size() == count) return;
  part.hulls.clear();
  part.shape = Shape::block;
}

}  // namespace

void PartChanges::expect(const PartDraft& part, Aspect aspect, const Cause& cause) {
  const auto [known, isNew] = known_.try_emplace(part.id);
  InFile& was = known->second;
  if (isNew)
    was = {part.solid, part.touch, part.anchored, part.transparency, part.size, part.pose, {}};
  was.causes[size_t(aspect)] = cause;
}

void PartChanges::settle(RoleContext& context) const {
  for (const auto& [id, was] : known_) settle(context.tree, *context.part(id), was);
}

void PartChanges::settle(const Tree& tree, PartDraft& part, const InFile& was) {
  const auto say = [&](Aspect aspect, const std::string& what) {
    const std::string reason = was.causes[size_t(aspect)].reason(tree);
    part.evidence.push_back({"scripted", what + "; " + reason, false});
  };
  if (part.solid != was.solid) say(Aspect::solid, part.solid ? "solid" : "not solid");
  if (part.touch != was.touch)
    say(Aspect::touch, part.touch ? "can be touched" : "cannot be touched");
  if (part.anchored != was.anchored)
    say(Aspect::anchored, part.anchored ? "anchored" : "not anchored");
  if (part.transparency != was.transparency)
    say(Aspect::transparency, fmt::format("transparency {:.3g}", part.transparency));
  if (!(part.size == was.size)) {
    resizeHulls(part, was.size);
    say(Aspect::size, "resized");
  }
  if (samePose(part.pose, was.pose)) {
    part.pose = was.pose;
  } else {
    part.rest = was.pose;
    say(Aspect::pose, "placed");
  }
}

}  // namespace obby::importer
