#include "import/stages/course.h"

#include <algorithm>

#include "engine/classes/class_defaults.h"

namespace obby::importer {
namespace {

constexpr size_t kMaxPortals = 64;  // bounds the work
// Studs; farther than any jump between two checkpoints. Long courses may have long segments, so the
// distance must also be out of proportion: segments of one course differ by less than this factor.
constexpr float kFar = 150, kOutOfProportion = 3;

// Returns the longest distance in studs, or 0 for fewer than two checkpoints.
float longestBetweenCheckpoints(const Course& course) {
  const std::vector<int>& parts = course.checkpoints;
  float longest = 0;
  for (size_t i = 1; i < parts.size(); ++i)
    longest = std::max(longest, course.distance(parts[i - 1], parts[i]));
  return longest;
}

}  // namespace

bool Course::is(int index, const char* flag) const { return get<bool>(instance(index), flag); }

const Team* Course::teamOf(int spawn) const {
  if (is(spawn, "Neutral")) return nullptr;
  const auto color = get<int64_t>(instance(spawn), "TeamColor");
  const auto found =
      std::find_if(teams.begin(), teams.end(), [&](const Team& t) { return t.color == color; });
  return found == teams.end() ? nullptr : &*found;
}

float Course::distance(int from, int to) const {
  const Vec3 a = part(from).pose.position, b = part(to).pose.position;
  float best = length(a - b);
  for (const auto& [entry, exit] : portals)
    best = std::min(best, length(a - entry) + length(exit - b));
  return best;
}

bool Course::isFar(float studs) const {
  const float longest = longestBetweenCheckpoints(*this);
  return longest > 0 && studs > std::max(kFar, kOutOfProportion * longest);
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
    if (part.teleport && course.portals.size() < kMaxPortals)
      course.portals.emplace_back(part.pose.position, part.teleport->position);
  return course;
}

}  // namespace obby::importer
