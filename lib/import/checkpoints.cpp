// Finds the start, orders the checkpoints, settles the goal.
#include "import/checkpoints.h"

#include <algorithm>
#include <map>

#include "engine/classes/class_defaults.h"
#include "import/pose_math.h"
#include "import/words.h"

namespace obby::importer {
namespace {

constexpr float kSameLobby = 24;           // studs between pads that are one start
constexpr size_t kMostByDistance = 10000;  // checkpoints of a level: bounds the work
constexpr std::string_view kStartWords[] = {"start", "lobby", "spawn", "mapstart", "inicio"};

struct Stages {
  const Tree& tree;
  LevelDraft& level;
  int start = -1;                // part index
  std::vector<int> checkpoints;  // part indices
  std::map<int64_t, int> teams;  // the number in the name of the team of each colour

  const Instance& instance(int part) const { return tree.at(level.parts[size_t(part)].id); }
  Vec3 position(int part) const { return level.parts[size_t(part)].pose.position; }
  float distance(int a, int b) const { return length(position(a) - position(b)); }
};

// The colour of the team that players get by themselves, if the place has teams.
std::optional<int64_t> firstTeamColor(const Tree& tree) {
  const InstanceId teams = tree.service("Teams");
  if (teams == kNoInstance) return std::nullopt;
  for (InstanceId team : tree.at(teams).children)
    if (tree.at(team).className == "Team" && propertyOr(tree.at(team), "AutoAssignable", true))
      return get<int64_t>(tree.at(team), "TeamColor");
  return std::nullopt;
}

// kUnnumbered where a team's name has none. Of teams of one colour the first counts. Empty where
// less than half have one: a number in free text ("4 Way Jump") is no place in an order.
std::map<int64_t, int> numbersOfTeams(const Tree& tree) {
  std::map<int64_t, int> numbers;
  const InstanceId teams = tree.service("Teams");
  if (teams == kNoInstance) return numbers;
  for (InstanceId team : tree.at(teams).children)
    if (tree.at(team).className == "Team")
      numbers.emplace(get<int64_t>(tree.at(team), "TeamColor"),
                      firstNumber(tree.at(team).name).value_or(kUnnumbered));
  const auto numbered = std::count_if(numbers.begin(), numbers.end(),
                                      [](const auto& team) { return team.second != kUnnumbered; });
  if (2 * size_t(numbered) < numbers.size()) numbers.clear();
  return numbers;
}

std::vector<int> enabledSpawns(const Stages& stages) {
  std::vector<int> spawns;
  for (int i = 0; i < int(stages.level.parts.size()); ++i)
    if (stages.instance(i).className == "SpawnLocation" && get<bool>(stages.instance(i), "Enabled"))
      spawns.push_back(i);
  return spawns;
}

// Smaller is a better start.
int startRank(const Stages& stages, int spawn, std::optional<int64_t> team) {
  const Instance& instance = stages.instance(spawn);
  const bool neutral = get<bool>(instance, "Neutral");
  if (team && !neutral && get<int64_t>(instance, "TeamColor") == *team) return 0;
  if (firstWordIn(instance.name, std::initializer_list<std::string_view>{"start", "lobby"}) != "")
    return 1;
  if (stages.level.parts[size_t(spawn)].checkpoint) return 4;
  return neutral && !get<bool>(instance, "AllowTeamChangeOnTouch") ? 2 : 3;
}

// Of a SpawnLocation: its own number, else that of the team that it is for.
int numberOf(const Stages& stages, int spawn) {
  const auto& draft = stages.level.parts[size_t(spawn)];
  if (draft.checkpoint) return *draft.checkpoint;
  const int number = stageNumber(stages.tree, draft.id, draft.id);
  const Instance& instance = stages.instance(spawn);
  if (number != kUnnumbered || get<bool>(instance, "Neutral")) return number;
  const auto team = stages.teams.find(get<int64_t>(instance, "TeamColor"));
  return team == stages.teams.end() ? kUnnumbered : team->second;
}

void startFromSpawns(Stages& stages, const std::vector<int>& spawns) {
  const auto team = firstTeamColor(stages.tree);
  const auto key = [&](int spawn) {
    const int number = numberOf(stages, spawn);
    return std::tuple(startRank(stages, spawn, team), number == kUnnumbered ? 0 : number, spawn);
  };
  stages.start = *std::min_element(spawns.begin(), spawns.end(),
                                   [&](int a, int b) { return key(a) < key(b); });
  auto& start = stages.level.parts[size_t(stages.start)];
  start.evidence.push_back({"start", "SpawnLocation", spawns.size() > 1});
  const int startNumber = numberOf(stages, stages.start);
  for (int spawn : spawns) {
    auto& part = stages.level.parts[size_t(spawn)];
    if (spawn == stages.start || part.checkpoint) continue;
    const int number = numberOf(stages, spawn);
    const bool changesTeam = get<bool>(stages.instance(spawn), "AllowTeamChangeOnTouch");
    const bool isOther = number != kUnnumbered && number != startNumber;
    if (!isOther && !changesTeam && stages.distance(spawn, stages.start) < kSameLobby) {
      part.evidence.push_back({"start", "SpawnLocation next to the start", true});
      continue;
    }
    part.checkpoint = number;
    part.evidence.push_back({"checkpoint",
                             changesTeam ? "SpawnLocation that changes the team" : "SpawnLocation",
                             number == kUnnumbered && !changesTeam});
  }
}

// No SpawnLocation: a part called Start, else the first checkpoint.
void startFromNames(Stages& stages) {
  for (int i = 0; i < int(stages.level.parts.size()); ++i) {
    const auto words = wordsOf(stages.instance(i).name);
    const PartDraft& part = stages.level.parts[size_t(i)];
    if (words.size() > 2 || words.empty() || part.kill || part.goal || part.motion) continue;
    if (firstWordIn(stages.instance(i).name, kStartWords).empty()) continue;
    stages.start = i;
    stages.level.parts[size_t(i)].evidence.push_back(
        {"start", "name " + stages.instance(i).name, true});
    return;
  }
}

// Checkpoints of one number, or without any: from each the nearest next.
void orderByDistance(Stages& stages, std::vector<int>::iterator first,
                     std::vector<int>::iterator end, const std::string& why) {
  if (end - first < 2 || stages.checkpoints.size() > kMostByDistance) return;
  for (; first != end; ++first) {
    const int last = first == stages.checkpoints.begin() ? stages.start : *(first - 1);
    std::iter_swap(first, std::min_element(first, end, [&](int a, int b) {
                     return stages.distance(a, last) < stages.distance(b, last);
                   }));
    stages.level.parts[size_t(*first)].evidence.push_back(
        {"checkpoint", "ordered by distance: " + why, true});
  }
}

void orderCheckpoints(Stages& stages) {
  auto& list = stages.checkpoints;
  const auto number = [&](int part) { return *stages.level.parts[size_t(part)].checkpoint; };
  std::stable_sort(list.begin(), list.end(), [&](int a, int b) {
    const auto key = [&](int p) { return number(p) == kUnnumbered ? 1 << 30 : number(p); };
    return key(a) < key(b);
  });
  if (stages.start < 0 && !list.empty()) {
    stages.start = list.front();
    stages.level.parts[size_t(stages.start)].evidence.push_back(
        {"start", "first checkpoint, as there is no SpawnLocation", true});
  }
  list.erase(std::remove(list.begin(), list.end(), stages.start), list.end());
  for (auto first = list.begin(); first != list.end();) {
    const int its = number(*first);
    const auto end = std::find_if(first, list.end(), [&](int p) { return number(p) != its; });
    orderByDistance(stages, first, end,
                    its == kUnnumbered ? "it has no number" : "others have its number");
    first = end;
  }
}

void settleGoal(Stages& stages) {
  std::vector<int> goals;
  bool stated = false;
  for (int i = 0; i < int(stages.level.parts.size()); ++i) {
    const auto& part = stages.level.parts[size_t(i)];
    if (!part.goal) continue;
    goals.push_back(i);
    for (const auto& e : part.evidence) stated = stated || (e.role == "goal" && !e.guessed);
  }
  if (goals.empty()) {
    if (stages.checkpoints.empty()) return;
    auto& last = stages.level.parts[size_t(stages.checkpoints.back())];
    last.goal = 0;
    last.evidence.push_back({"goal", "last checkpoint", true});
    return;
  }
  if (stated || goals.size() == 1 || stages.start < 0) return;
  // Several guesses: the one beside the start in the tree, else the farthest.
  const InstanceId family = stages.instance(stages.start).parent;
  const auto rank = [&](int goal) {
    return std::pair(stages.instance(goal).parent == family, stages.distance(goal, stages.start));
  };
  const int best = *std::max_element(goals.begin(), goals.end(),
                                     [&](int a, int b) { return rank(a) < rank(b); });
  for (int goal : goals) {
    if (goal == best) continue;
    stages.level.parts[size_t(goal)].goal.reset();
    auto& evidence = stages.level.parts[size_t(goal)].evidence;
    std::erase_if(evidence, [](const Evidence& e) { return e.role == "goal"; });
    stages.level.noteIgnored("name that suggests a goal",
                             stages.tree.path(stages.level.parts[size_t(goal)].id),
                             "another part is the goal");
  }
}

}  // namespace

SpawnDraft spawnOn(const Tree& tree, const PartDraft& part, int index, int stage) {
  SpawnDraft spawn;
  spawn.name = tree.at(part.id).name;
  spawn.stage = stage;
  const Vec3 half = boundsOf(part.pose, part.size * 0.5f).hi - part.pose.position;
  spawn.position = part.pose.position + Vec3{0, half.y, 0};
  spawn.yaw = yawOf(-part.pose.rotation.z);
  spawn.part = index;
  return spawn;
}

void orderStages(const Tree& tree, LevelDraft& level) {
  Stages stages{tree, level, -1, {}, numbersOfTeams(tree)};
  const auto spawns = enabledSpawns(stages);
  if (!spawns.empty())
    startFromSpawns(stages, spawns);
  else
    startFromNames(stages);
  for (int i = 0; i < int(level.parts.size()); ++i)
    if (level.parts[size_t(i)].checkpoint) stages.checkpoints.push_back(i);
  orderCheckpoints(stages);
  settleGoal(stages);
  if (stages.start >= 0) {
    auto& start = level.parts[size_t(stages.start)];
    start.checkpoint.reset();
    level.spawns.push_back(spawnOn(tree, start, stages.start, 0));
  }
  int stage = 0;
  for (int index : stages.checkpoints) {
    level.parts[size_t(index)].checkpoint = ++stage;
    level.spawns.push_back(spawnOn(tree, level.parts[size_t(index)], index, stage));
  }
}

}  // namespace obby::importer
