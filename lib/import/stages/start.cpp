// Finds the start, and the meaning of the other SpawnLocations.
#include <algorithm>
#include <set>
#include <tuple>

#include "engine/classes/class_defaults.h"
#include "import/document/words.h"
#include "import/stages/course.h"
#include "import/stages/numbers.h"
#include "import/stages/stage_words.h"

namespace obby::importer {
namespace {

constexpr float kOnTop = 8;  // max studs between a pad and a player placed by scripts

// Suitability of a SpawnLocation as the start, best first.
enum class StartRank {
  ofFirstTeam,  // belongs to the team of new players
  named,        // "Start"
  open,         // open to all teams, and does not change the player's team
  other,
  checkpoint,  // known by its tag, its script or its number
  winners      // players appear there after the end
};

bool isForWinners(std::string_view name) { return hasStageWord(kWinnersWord, name); }

// Returns the middle of the part's top.
Vec3 topOf(const PartDraft& part) {
  const Vec3& middle = part.pose.position;
  return {middle.x, boundsOf(part.pose, part.size * 0.5f).hi.y, middle.z};
}

void giveGoal(Course& course, int index, const char* why) {
  PartDraft& part = course.part(index);
  part.checkpoint.reset();
  if (!part.goal) part.goal = 0;
  course.prove(index, "goal", why, false);
}

// Finds pads that scripts gave to the winners' team in the run.
void findWinnersPads(Course& course) {
  for (int i = 0; i < int(course.level.parts.size()); ++i)
    for (const Team& team : course.teams)
      if (course.part(i).stageSigns.team == team.color && isForWinners(team.name))
        giveGoal(course, i, "sets the winners' team");
}

class SpawnRoles {
 public:
  explicit SpawnRoles(Course& course) : course_(course) {
    for (int i = 0; i < int(course.level.parts.size()); ++i) {
      if (course.instance(i).className != "SpawnLocation" || !course.is(i, "Enabled")) continue;
      spawns_.push_back(i);
      read(i);
    }
    for (const PartDraft& part : course.level.parts)
      if (part.checkpoint && part.stageSigns.respawn != part.id)
        remote_.insert(part.stageSigns.respawn);
  }

  bool empty() const { return spawns_.empty(); }

  // Returns true if the feet are on a SpawnLocation: the engine itself puts players there.
  bool isOnOne(Vec3 feet) const {
    return std::any_of(spawns_.begin(), spawns_.end(), [&](int spawn) {
      const PartDraft& part = course_.part(spawn);
      const Vec3 off = feet - topOf(part);
      return absf(off.y) < 1 && length(Vec3{off.x, 0, off.z}) < length(part.size) / 2;
    });
  }

  void give() {
    chooseStart();
    for (const int spawn : spawns_)
      if (spawn != course_.start) giveRole(spawn);
  }

 private:
  void read(int spawn) {
    PartDraft& part = course_.part(spawn);
    readNumbers(course_.tree, part.id, part);
    const Team* const team = course_.teamOf(spawn);
    if (!team) return;
    part.stageSigns[NumberFrom::team] = firstNumber(team->name).value_or(kUnnumbered);
  }

  // Returns the SpawnLocation's own number, else that of its folder or team.
  int numberOf(int spawn) const {
    const StageSigns& signs = course_.part(spawn).stageSigns;
    for (const NumberFrom from : {NumberFrom::tag, NumberFrom::value, NumberFrom::name,
                                  NumberFrom::folder, NumberFrom::team})
      if (signs[from] != kUnnumbered) return signs[from];
    return kUnnumbered;
  }

  bool forWinners(int spawn) const {
    const InstanceId parent = course_.instance(spawn).parent;
    const Team* const team = course_.teamOf(spawn);
    return isForWinners(course_.instance(spawn).name) || (team && isForWinners(team->name)) ||
           (parent != kNoInstance && isForWinners(course_.tree.at(parent).name));
  }

  // Returns the team of a new player. Players are spread over the teams, so the one with the lowest
  // number counts.
  const Team* firstTeam() const {
    const Team* first = nullptr;
    const auto number = [](const Team& team) { return firstNumber(team.name).value_or(0); };
    for (const Team& team : course_.teams)
      if (team.autoAssigned && !isForWinners(team.name) &&
          (!first || number(team) < number(*first)))
        first = &team;
    return first;
  }

  StartRank rank(int spawn, const Team* first) const {
    if (forWinners(spawn)) return StartRank::winners;
    const Team* const team = course_.teamOf(spawn);
    if (team && first && team->color == first->color) return StartRank::ofFirstTeam;
    if (hasStageWord(kSureStartWord, course_.instance(spawn).name)) return StartRank::named;
    if (course_.part(spawn).checkpoint) return StartRank::checkpoint;
    const bool isOpen =
        course_.is(spawn, "Neutral") && !course_.is(spawn, "AllowTeamChangeOnTouch");
    return isOpen ? StartRank::open : StartRank::other;
  }

  // Returns the checkpoint with the lowest number, or -1 if none has a number.
  int firstCheckpoint() const {
    std::vector<int> known;
    for (int i = 0; i < int(course_.level.parts.size()); ++i)
      if (course_.part(i).checkpoint) known.push_back(i);
    const std::vector<int> numbers = numbersThatCount(course_.level, known);
    int best = -1;
    for (size_t i = 0; i < known.size(); ++i)
      if (numbers[i] != kUnnumbered && (best < 0 || numbers[i] < numbers[size_t(best)]))
        best = int(i);
    return best < 0 ? -1 : known[size_t(best)];
  }

  void chooseStart() {
    const Team* const team = firstTeam();
    const int first = firstCheckpoint();
    const auto key = [&](int spawn) {
      const int number = numberOf(spawn);
      const float away = first < 0 ? 0 : course_.distance(spawn, first);
      return std::tuple(rank(spawn, team), number == kUnnumbered ? 0 : number, away, spawn);
    };
    course_.start = *std::min_element(spawns_.begin(), spawns_.end(),
                                      [&](int a, int b) { return key(a) < key(b); });
    course_.prove(course_.start, "start", "SpawnLocation", spawns_.size() > 1);
  }

  void giveRole(int spawn) {
    PartDraft& part = course_.part(spawn);
    const bool changesTeam = course_.is(spawn, "AllowTeamChangeOnTouch");
    if (forWinners(spawn)) return giveWinners(spawn, changesTeam || part.checkpoint);
    if (part.checkpoint) return;
    if (remote_.contains(part.id))
      return course_.prove(spawn, "start",
                           "a checkpoint elsewhere respawns players at this SpawnLocation", false);
    const int number = numberOf(spawn);
    const bool isOther = number != kUnnumbered && number != numberOf(course_.start);
    if (!isOther && !changesTeam) return giveStart(spawn);
    if (!changesTeam && isNextToItsStage(spawn))
      return course_.prove(spawn, "start", "SpawnLocation next to another one of the same stage",
                           true);
    part.checkpoint = kUnnumbered;
    course_.prove(spawn, "checkpoint",
                  changesTeam ? "SpawnLocation that changes the team" : "SpawnLocation",
                  !changesTeam);
  }

  bool areNear(int a, int b) const {
    return length(course_.part(a).pose.position - course_.part(b).pose.position) < kOnePlatform;
  }

  // Returns true if a checkpoint with the SpawnLocation's number is near it.
  bool isNextToItsStage(int spawn) const {
    return std::any_of(spawns_.begin(), spawns_.end(), [&](int other) {
      return other != spawn && course_.part(other).checkpoint && areNear(spawn, other) &&
             numberOf(other) == numberOf(spawn);
    });
  }

  void giveStart(int spawn) {
    const bool near = areNear(spawn, course_.start);
    const Team* const team = course_.teamOf(spawn);
    course_.prove(spawn, "start",
                  near   ? "SpawnLocation next to the start"
                  : team ? "SpawnLocation of the team " + team->name
                         : "another SpawnLocation",
                  true);
  }

  // Makes a goal of a winners' pad that players can walk onto. Otherwise the part that brings
  // players there is the goal.
  void giveWinners(int spawn, bool isReached) {
    PartDraft& part = course_.part(spawn);
    part.checkpoint.reset();
    if (isReached) return giveGoal(course_, spawn, "SpawnLocation of the winners");
    course_.prove(spawn, "start", "SpawnLocation of the winners", true);
    for (int i = 0; i < int(course_.level.parts.size()); ++i) {
      const PartDraft& other = course_.part(i);
      const bool leads =
          other.teleport && length(other.teleport->position - part.pose.position) < kOnePlatform;
      if (i != spawn && (leads || other.stageSigns.respawn == part.id))
        giveGoal(course_, i, "leads to the winners' SpawnLocation");
    }
  }

  Course& course_;
  std::vector<int> spawns_;
  std::set<InstanceId> remote_;  // SpawnLocations that checkpoints elsewhere set
};

// Makes the first part with a start word in its name (Start, Lobby) the start. Call it if there is
// no SpawnLocation.
void startFromNames(Course& course) {
  for (int i = 0; i < int(course.level.parts.size()); ++i) {
    const std::string& name = course.instance(i).name;
    const auto words = wordsOf(name);
    const PartDraft& part = course.part(i);
    if (words.size() > 2 || words.empty() || part.kill || part.goal || part.motion) continue;
    if (!hasStageWord(kStartWord, name)) continue;
    course.start = i;
    return course.prove(i, "start", "name " + name, true);
  }
}

// Returns the highest solid part below the feet, else a part around the body, or -1 if none is
// near.
int partBelow(const Course& course, Vec3 feet) {
  constexpr float kToRoot = 3, kSunk = 0.5f;  // studs
  for (const float into : {0.0f, kToRoot}) {
    int best = -1;
    float highest = feet.y - kOnTop;
    for (int i = 0; i < int(course.level.parts.size()); ++i) {
      const PartDraft& part = course.part(i);
      const auto bounds = boundsOf(part.pose, part.size * 0.5f);
      const bool over = feet.x >= bounds.lo.x && feet.x <= bounds.hi.x && feet.z >= bounds.lo.z &&
                        feet.z <= bounds.hi.z && bounds.lo.y <= feet.y + into;
      const bool fits = into > 0 || (part.solid && bounds.hi.y <= feet.y + kSunk);
      if (!over || !fits || bounds.hi.y < highest) continue;
      highest = bounds.hi.y;
      best = i;
    }
    if (best >= 0) return best;
  }
  return -1;
}

}  // namespace

void findStart(Course& course, const std::optional<Vec3>& arrived) {
  findWinnersPads(course);
  SpawnRoles spawns(course);
  if (spawns.empty())
    startFromNames(course);
  else
    spawns.give();
  if (!arrived || spawns.isOnOne(*arrived)) return;
  // Scripts have put the player there.
  const int below = partBelow(course, *arrived);
  if (below < 0 || below == course.start) return;
  course.start = below;
  const bool isInside = course.part(below).solid && topOf(course.part(below)).y > arrived->y;
  if (!course.part(below).checkpoint && !isInside) course.arrived = arrived;
  course.prove(below, "start", "scripts put new players there", false);
}

}  // namespace obby::importer
