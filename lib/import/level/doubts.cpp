#include "import/level/doubts.h"

#include <algorithm>

#include "import/document/classes.h"

namespace obby::importer {
namespace {

// Losses that can only make the game easier than the level: players may ignore them.
constexpr std::string_view kEasier[] = {"ability of the player",
                                        "button on the screen",
                                        "chat that scripts listen to",
                                        "harm that goes on after a touch",
                                        "harm that a force field stops",
                                        "keys that a script listens to",
                                        "input without a visible effect",
                                        "part that players drag",
                                        "script still waiting at the end of the run",
                                        "tag balloon",
                                        "tag swing",
                                        "tag walljump",
                                        "tag zipline",
                                        "tool",
                                        "interaction that affects the player"};
// A part with this motion may reach a player anywhere; if it kills, no part of the level is safe.
constexpr std::string_view kNoPeriod = "motion without a period";
constexpr std::string_view kHarder[] = {"harm by climbing, swimming or sitting",
                                        "harm by falling",
                                        "harm without a touch",
                                        "harm by jumping",
                                        "harm by walking",
                                        "controls that scripts take away",
                                        "part that stops the player",
                                        "player that cannot walk",
                                        "script that acts on players without a touch",
                                        "state of the player that scripts switch off",
                                        "tag trippart"};

template <size_t n>
bool listed(const std::string_view (&kinds)[n], std::string_view kind) {
  return std::find(std::begin(kinds), std::end(kinds), kind) != std::end(kinds);
}

bool isJointClass(const std::string& name) {
  return isFreeConstraintClass(name) || isRigidJointClass(name);
}

class Concerned {
 public:
  explicit Concerned(RoleContext& context)
      : context_(context), maxConcerned_(context.level.parts.size() / 2) {}

  // Returns the parts that a loss concerns. The list is empty if it concerns no part in particular.
  std::vector<PartDraft*> by(InstanceId loss) {
    for (InstanceId id = loss; id < context_.tree.size(); id = context_.tree.at(id).parent) {
      if (PartDraft* const part = context_.part(id)) return {part};
      if (isJointClass(context_.tree.at(id).className)) return endsOf(id);
      if (isWorld(id)) break;
      if (context_.hasParts(id)) return few(context_.partsOf(id));
    }
    return {};
  }

 private:
  bool isWorld(InstanceId id) const { return context_.tree.service("Workspace") == id; }
  std::vector<PartDraft*> endsOf(InstanceId joint) {
    const JointEnds ends = jointEnds(context_.tree, joint);
    std::vector<PartDraft*> parts;
    for (const InstanceId end : {ends.first, ends.second})
      if (PartDraft* const part = end == kNoInstance ? nullptr : context_.part(end))
        parts.push_back(part);
    return parts;
  }
  std::vector<PartDraft*> few(std::vector<PartDraft*> parts) const {
    if (parts.size() > std::max<size_t>(maxConcerned_, 1)) parts.clear();
    return parts;
  }

  RoleContext& context_;
  size_t maxConcerned_;  // a folder with more parts concerns no part in particular
};

}  // namespace

Bearing bearingOf(const std::string& kind) {
  if (listed(kEasier, kind)) return Bearing::easier;
  return listed(kHarder, kind) ? Bearing::harder : Bearing::either;
}

void markDoubts(RoleContext& context) {
  Concerned concerned(context);
  for (const Loss& loss : context.level.losses) {
    const auto parts = concerned.by(loss.at);
    const bool chases = loss.kind == kNoPeriod && !parts.empty() && parts.front()->kill;
    if (parts.empty() || chases) context.level.unmodelled.at(loss.kind).anywhere = true;
    for (PartDraft* part : parts) part->doubts.push_back(loss.kind);
  }
  for (PartDraft& part : context.level.parts) {
    std::sort(part.doubts.begin(), part.doubts.end());
    part.doubts.erase(std::unique(part.doubts.begin(), part.doubts.end()), part.doubts.end());
  }
}

}  // namespace obby::importer
