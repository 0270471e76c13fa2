#include "import/stages/course.h"

#include <algorithm>

#include "engine/classes/class_defaults.h"
#include "import/words.h"

namespace obby::importer {
namespace {

constexpr std::string_view kWinnersWords[] = {"winner",  "winners",   "win",       "victory",
                                              "finish",  "finished",  "finishers", "champions",
                                              "victors", "completed", "beaten"};
constexpr size_t kMostPortals = 64;    // bounds the work
constexpr float kFar = 150;            // studs: nobody jumps that far
constexpr float kOutOfProportion = 3;  // times the longest hop

}  // namespace

bool isForWinners(std::string_view name) { return !firstWordIn(name, kWinnersWords).empty(); }

bool Course::is(int index, const char* flag) const { return get<bool>(instance(index), flag); }

const Team* Course::teamOf(int spawn) const {
  if (is(spawn, "Neutral")) return nullptr;
  const auto color = get<int64_t>(instance(spawn), "TeamColor");
  const auto found =
      std::find_if(teams.begin(), teams.end(), [&](const Team& t) { return t.color == color; });
  return found == teams.end() ? nullptr : &*found;
}

float Course::hop(int from, int to) const {
  const Vec3 a = part(from).pose.position, b = part(to).pose.position;
  float best = length(a - b);
  for (const auto& [entry, exit] : portals)
    best = std::min(best, length(a - entry) + length(exit - b));
  return best;
}

float Course::longestHop() const {
  float longest = 0;
  for (size_t i = 1; i < checkpoints.size(); ++i)
    longest = std::max(longest, hop(checkpoints[i - 1], checkpoints[i]));
  return longest;
}

bool Course::isFar(float hop) const {
  const float longest = longestHop();
  return longest > 0 && hop > std::max(kFar, kOutOfProportion * longest);
}

Course courseOf(const Tree& tree, LevelDraft& level) {
  Course course{tree, level};
  const InstanceId teams = tree.service("Teams");
  if (teams != kNoInstance)
    for (const InstanceId id : tree.at(teams).children)
      if (const Instance& team = tree.at(id); team.className == "Team")
        course.teams.push_back(
            {get<int64_t>(team, "TeamColor"), team.name, propertyOr(team, "AutoAssignable", true)});
  for (const PartDraft& part : level.parts)
    if (part.teleport && course.portals.size() < kMostPortals)
      course.portals.emplace_back(part.pose.position, part.teleport->position);
  return course;
}

}  // namespace obby::importer
