// Finds the end of the level.
#include <algorithm>

#include "import/stages/course.h"

namespace obby::importer {
namespace {

void dropGuess(Course& course, int goal, const char* why) {
  PartDraft& part = course.part(goal);
  part.goal.reset();
  std::erase_if(part.evidence, [](const Evidence& e) { return e.role == "goal"; });
  course.level.noteIgnored("name that suggests a goal", course.tree.path(part.id), why);
}

void endAtLastCheckpoint(Course& course) {
  if (course.checkpoints.empty()) return;
  const int last = course.checkpoints.back();
  course.part(last).goal = 0;
  course.prove(last, "goal", "last checkpoint", true);
}

// Returns the guess that is nearest to the last checkpoint. Without checkpoints it is the one that
// shares a folder with the start, else the farthest.
int bestGuess(const Course& course, const std::vector<int>& goals) {
  const bool hasLast = !course.checkpoints.empty();
  const int from = hasLast ? course.checkpoints.back() : course.start;
  const InstanceId family = course.instance(course.start).parent;
  const auto rank = [&](int goal) {
    const float away = course.distance(from, goal);
    return std::pair(!hasLast && course.instance(goal).parent == family, hasLast ? -away : away);
  };
  return *std::max_element(goals.begin(), goals.end(),
                           [&](int a, int b) { return rank(a) < rank(b); });
}

}  // namespace

void settleGoal(Course& course) {
  std::vector<int> goals;
  bool stated = false;
  for (int i = 0; i < int(course.level.parts.size()); ++i) {
    const PartDraft& part = course.part(i);
    if (!part.goal) continue;
    goals.push_back(i);
    for (const auto& e : part.evidence) stated = stated || (e.role == "goal" && !e.guessed);
  }
  if (goals.empty()) return endAtLastCheckpoint(course);
  if (stated) {
    for (const int goal : goals) {
      const auto& evidence = course.part(goal).evidence;
      const bool isGuess = std::none_of(evidence.begin(), evidence.end(), [](const Evidence& e) {
        return e.role == "goal" && !e.guessed;
      });
      if (isGuess) dropGuess(course, goal, "another part is the goal");
    }
    return;
  }
  if (course.start < 0) return;
  const int best = bestGuess(course, goals);
  for (const int goal : goals)
    if (goal != best) dropGuess(course, goal, "another part is the goal");
  if (course.checkpoints.empty() || course.part(best).checkpoint ||
      !course.isFar(course.distance(course.checkpoints.back(), best)))
    return;
  dropGuess(course, best, "it is far from the last checkpoint");
  endAtLastCheckpoint(course);
}

}  // namespace obby::importer
