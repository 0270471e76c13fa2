#include "train/settings.h"

#include <fmt/format.h>

#include <utility>

namespace obby::train {

namespace {

// Former names of settings, in checkpoints of earlier versions.
constexpr std::pair<const char*, const char*> kFormerSettings[] = {
    {"crowds", "env groups"},
    {"levels of a crowd", "levels of an env group"},
    {"playthroughs of a level", "episodes of a level"},
    {"clip", "clip range"},
    {"value share", "value weight"},
    {"passes", "epochs"},
    {"part", "minibatch"},
    {"rate", "learning-rate"},
    {"most norm", "max grad norm"},
};

}  // namespace

std::string presentSettingName(const std::string& name) {
  for (const auto& [former, present] : kFormerSettings)
    if (name == former) return present;
  return name;
}

std::vector<Setting> settingsOf(const TrainerSettings& s) {
  std::vector<Setting> out;
  const auto add = [&](const char* name, auto value) {
    out.push_back({name, fmt::format("{}", value)});
  };
  // Settings with a command line option have its name.
  add("seed", s.seed);
  add("worlds", s.envGroups * s.envGroup.levels * s.envGroup.worlds);
  add("env groups", s.envGroups);
  add("levels of an env group", s.envGroup.levels);
  add("episodes of a level", s.envGroup.episodes);
  add("restart share", s.envGroup.restarts.unsolved);
  add("restart share of solved levels", s.envGroup.restarts.solved);
  add("patience", s.envGroup.patience);
  add("reward of a stud", s.envGroup.reward.stud);
  add("reward of the goal", s.envGroup.reward.goal);
  add("reward of a death", s.envGroup.reward.death);
  add("reward of a decision", s.envGroup.reward.decision);
  add("reward of a jump", s.envGroup.reward.jump);
  add("ticks", s.ticks);
  add("clip range", s.ppo.loss.clip);
  add("value weight", s.ppo.loss.valueWeight);
  add("entropy", s.ppo.loss.entropyWeight);
  add("discount", s.ppo.discount);
  add("lambda", s.ppo.lambda);
  add("epochs", s.ppo.epochs);
  add("minibatch", s.ppo.minibatch);
  add("learning-rate", s.ppo.learningRate);
  add("max grad norm", s.ppo.maxGradNorm);
  add("decisions", s.decisions);
  add("easiest", s.easiest);
  add("raise at", s.raiseAt);
  add("lower at", s.lowerAt);
  return out;
}

Status sameSettings(const std::vector<Setting>& then, const std::vector<Setting>& now) {
  const auto valueOf = [](const std::vector<Setting>& list, const std::string& name) {
    for (const Setting& s : list)
      if (s.name == name) return s.value;
    return std::string("absent");
  };
  const auto differs = [&](const std::string& name) -> Status {
    const std::string before = valueOf(then, name), after = valueOf(now, name);
    if (before == after) return {};
    return makeError(
        fmt::format("'{}' was {} in the earlier run and is {} now", name, before, after),
        "use the options of the earlier run, or start again without --resume");
  };
  for (const Setting& s : now) OBBY_RETURN_IF_ERROR(differs(s.name));
  for (const Setting& s : then) OBBY_RETURN_IF_ERROR(differs(s.name));
  return {};
}

}  // namespace obby::train
