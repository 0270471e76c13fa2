#include "import/observed/progress.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "import/document/tree.h"
#include "import/document/words.h"
#include "import/stages/numbers.h"
#include "import/stages/stage_words.h"

namespace obby::importer {
namespace {

constexpr std::string_view kStageWords[] = {"stage", "level", "checkpoint", "spawn"};

StageSet& stageIn(ProbeEffects& effects, engine::Line line) {
  if (!effects.stage) {
    effects.stage = StageSet{};
    effects.stage->line = line;
  }
  return *effects.stage;
}

// Returns the number, or the first one in the text.
std::optional<int> wholeOf(const engine::Plain& value) {
  if (const auto* const text = std::get_if<std::string>(&value)) return firstNumber(*text);
  const auto* const number = std::get_if<double>(&value);
  if (!number || std::floor(*number) != *number) return {};
  return asStage(*number);
}

void takeStat(ProbeEffects& effects, const std::string& name, const engine::Change& note) {
  const std::string small = lower(name);
  const std::optional<int> number = wholeOf(note.value);
  const bool* const flag = std::get_if<bool>(&note.value);
  if (hasAny(small, kStageWords)) {
    if (!number) return;
    StageSet& stage = stageIn(effects, note.line);
    stage.number = stage.number.value_or(*number);
  } else if (hasStageWord(kWinsWord, name)) {
    if ((number && *number > 0) || (flag && *flag)) effects.won = effects.won.value_or(note.line);
  } else if (number) {
    effects.unnamed.push_back({*number, note.line});
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
  for (const UnnamedStat& stat : effects.unnamed) {
    if (effects.stage) return;
    if (std::find(numbersOfPart.begin(), numbersOfPart.end(), stat.number) != numbersOfPart.end())
      stageIn(effects, stat.line).number = stat.number;
  }
}

void takeComeback(ProbeEffects& effects, const engine::Report& report, const engine::Probe& probe,
                  const PartDraft& part) {
  constexpr float kMoved = 2;  // studs; a body that appears at its old spawn is closer
  // Studs around the part. Scripts drop the body from above it, or put it at an edge. Zone parts
  // reach below the floor.
  constexpr float kAround = 3, kAbove = 10, kBelow = 2;
  const Vec3 feet = probe.rebornAt;
  if (!probe.reborn || length(feet - report.arrived.feet) < kMoved) return;
  if (effects.stage && effects.harm) {
    effects.teleport = Teleported{feet, false, 0, effects.stage->line};
    effects.harm.reset();
    effects.stage.reset();
  }
  if (effects.stage || effects.teleport) return;
  const auto bounds = boundsOf(part.pose, part.size * 0.5f);
  const bool isThere = feet.x > bounds.lo.x - kAround && feet.x < bounds.hi.x + kAround &&
                       feet.z > bounds.lo.z - kAround && feet.z < bounds.hi.z + kAround &&
                       feet.y > bounds.lo.y - kBelow && feet.y < bounds.hi.y + kAbove;
  if (isThere) stageIn(effects, {});
}

}  // namespace obby::importer
