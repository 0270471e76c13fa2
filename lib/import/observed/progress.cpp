#include "import/observed/progress.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "import/tree.h"
#include "import/words.h"

namespace obby::importer {
namespace {

constexpr std::string_view kStageWords[] = {"stage", "level", "checkpoint", "spawn"};
constexpr std::string_view kWinWords[] = {"win",      "wins",      "won",        "victories",
                                          "finished", "completed", "completions"};
constexpr double kMost = 1e6;

StageSet& stageIn(ProbeEffects& effects, engine::Line line) {
  if (!effects.stage) {
    effects.stage = StageSet{};
    effects.stage->line = line;
  }
  return *effects.stage;
}

// The number, or the first one in the text.
std::optional<int> wholeOf(const engine::Plain& value) {
  if (const auto* const text = std::get_if<std::string>(&value)) return firstNumber(*text);
  const auto* const number = std::get_if<double>(&value);
  if (!number || !(*number >= 0) || !(*number < kMost) || std::floor(*number) != *number) return {};
  return int(*number);
}

void takeStat(ProbeEffects& effects, const std::string& name, const engine::Change& note) {
  const std::string small = lower(name);
  const std::optional<int> number = wholeOf(note.value);
  const bool* const flag = std::get_if<bool>(&note.value);
  if (hasAny(small, kStageWords)) {
    if (!number) return;
    StageSet& stage = stageIn(effects, note.line);
    stage.number = stage.number.value_or(*number);
  } else if (!firstWordIn(name, kWinWords).empty()) {
    if ((number && *number > 0) || (flag && *flag)) effects.won = effects.won.value_or(note.line);
  } else if (number) {
    effects.kept.push_back({*number, note.line});
  }
}

}  // namespace

bool takeProgress(ProbeEffects& effects, const engine::Change& note, InstanceId touched) {
  constexpr std::string_view kStat = "note stat ";
  const double* const number = std::get_if<double>(&note.value);
  if (note.property == "note respawn") {
    stageIn(effects, note.line).respawn = number && *number > 0 ? InstanceId(*number) : kNoInstance;
  } else if (note.property == "note team") {
    if (number) stageIn(effects, note.line).team = int64_t(*number);
  } else if (note.property == "note kept") {
    if (note.target == touched) stageIn(effects, note.line);
  } else if (note.property.rfind(kStat, 0) == 0) {
    takeStat(effects, note.property.substr(kStat.size()), note);
  } else {
    return false;
  }
  return true;
}

void takeOwnNumber(ProbeEffects& effects, std::initializer_list<int> numbersOfPart) {
  for (const Kept& kept : effects.kept) {
    if (effects.stage) return;
    if (std::find(numbersOfPart.begin(), numbersOfPart.end(), kept.number) != numbersOfPart.end())
      stageIn(effects, kept.line).number = kept.number;
  }
}

void takeComeback(ProbeEffects& effects, const engine::Report& report, const engine::Probe& probe,
                  const PartDraft& part) {
  constexpr float kMoved = 2, kBeside = 3, kAbove = 10, kBelow = 2;  // studs
  const Vec3 feet = probe.rebornAt;
  if (!probe.reborn || length(feet - report.arrived.feet) < kMoved) return;
  if (effects.stage && effects.harm) {
    effects.teleport = Teleported{feet, false, 0, effects.stage->line};
    effects.harm.reset();
    effects.stage.reset();
  }
  if (effects.stage || effects.teleport) return;
  const auto bounds = boundsOf(part.pose, part.size * 0.5f);
  const bool isThere = feet.x > bounds.lo.x - kBeside && feet.x < bounds.hi.x + kBeside &&
                       feet.z > bounds.lo.z - kBeside && feet.z < bounds.hi.z + kBeside &&
                       feet.y > bounds.lo.y - kBelow && feet.y < bounds.hi.y + kAbove;
  if (isThere) stageIn(effects, {});
}

}  // namespace obby::importer
