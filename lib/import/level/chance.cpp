#include "import/level/chance.h"

#include <algorithm>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "import/document/pose_math.h"

namespace obby::importer {
namespace {

constexpr const char* kByChance = "part that varies at random";
constexpr const char* kChanceNote = "simulated as it was in one run of the scripts";

// Clears the phase: a player who waits meets every phase.
template <class T>
std::optional<T> withoutPhase(std::optional<T> value, float T::*phase) {
  if (value) (*value).*phase = 0;
  return value;
}

// Returns the first property in which two drafts of a part differ for a player, else null.
const char* differenceOf(const PartDraft& a, const PartDraft& b) {
  if (!isSame(a.pose, b.pose)) return "its position";
  if (!(a.size == b.size) || a.shape != b.shape || a.hulls.size() != b.hulls.size())
    return "its shape";
  if (a.solid != b.solid || a.anchored != b.anchored || a.oneWay != b.oneWay)
    return "whether it is solid";
  if (a.kill != b.kill || a.touch != b.touch || a.byRoot != b.byRoot) return "whether it kills";
  if (withoutPhase(a.vanish, &Vanish::phase) != withoutPhase(b.vanish, &Vanish::phase))
    return "when it vanishes";
  if (withoutPhase(a.motion, &Motion::offset) != withoutPhase(b.motion, &Motion::offset))
    return "its motion";
  if (a.teleport != b.teleport) return "its destination";
  const auto effects = [](const PartDraft& part) {
    return std::tie(part.conveyor, part.jumpPad, part.boost, part.trip, part.button);
  };
  if (effects(a) != effects(b) || a.seat != b.seat || a.climbable != b.climbable)
    return "the effect of a touch";
  if (a.checkpoint != b.checkpoint || a.goal != b.goal) return "its stage";
  return nullptr;
}

// Parts that scripts made, by their heights: ids of different runs are unrelated.
class MadeParts {
 public:
  MadeParts(const LevelDraft& level, size_t fromFile) {
    for (const PartDraft& part : level.parts)
      if (part.id >= fromFile) byHeight_.emplace(part.pose.position.y, &part);
  }
  // Removes an equal part. Returns false if none is left.
  bool take(const PartDraft& part) {
    const auto [begin, end] = byHeight_.equal_range(part.pose.position.y);
    const auto found = std::find_if(
        begin, end, [&](const auto& other) { return !differenceOf(part, *other.second); });
    if (found == end) return false;
    byHeight_.erase(found);
    return true;
  }
  bool empty() const { return byHeight_.empty(); }

 private:
  std::multimap<float, const PartDraft*> byHeight_;
};

}  // namespace

void noteChance(LevelDraft& level, const Tree& tree, size_t fromFile, const LevelDraft& other) {
  std::unordered_map<InstanceId, const PartDraft*> others;
  for (const PartDraft& part : other.parts)
    if (part.id < fromFile) others[part.id] = &part;
  MadeParts made(other, fromFile);
  const auto note = [&](InstanceId part, const std::string& what) {
    if (!level.losses.contains({part, kByChance}))
      level.noteUnmodelled(kByChance, tree, part,
                           what + " depends on random numbers; " + kChanceNote);
  };
  for (const PartDraft& part : level.parts) {
    if (part.id >= fromFile) {
      if (!made.take(part)) note(part.id, "the part");
      continue;
    }
    const auto same = others.find(part.id);
    const char* const difference =
        same == others.end() ? "whether it is there" : differenceOf(part, *same->second);
    if (difference) note(part.id, difference);
    others.erase(part.id);
  }
  for (const auto& [id, part] : std::map(others.begin(), others.end()))
    note(id, "whether it is there");
  if (!made.empty()) note(kNoInstance, "the set of parts that scripts add");
}

}  // namespace obby::importer
