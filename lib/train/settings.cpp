#include "train/settings.h"

#include <fmt/format.h>

namespace obby::train {

std::vector<Setting> settingsOf(const TrainerSettings& s) {
  std::vector<Setting> out;
  const auto add = [&](const char* name, auto value) {
    out.push_back({name, fmt::format("{}", value)});
  };
  // Settings with a command line option have its name.
  add("seed", s.seed);
  add("worlds", s.envGroups * s.envGroup.levels * s.envGroup.worlds);
  add("crowds", s.envGroups);
  add("levels of a crowd", s.envGroup.levels);
  add("playthroughs of a level", s.envGroup.playthroughs);
  add("restart share", s.envGroup.restarts.unsolved);
  add("restart share of solved levels", s.envGroup.restarts.solved);
  add("patience", s.envGroup.patience);
  add("reward of a stud", s.envGroup.reward.stud);
  add("reward of the goal", s.envGroup.reward.goal);
  add("reward of a death", s.envGroup.reward.death);
  add("reward of a decision", s.envGroup.reward.decision);
  add("reward of a jump", s.envGroup.reward.jump);
  add("ticks", s.ticks);
  add("clip", s.ppo.loss.clip);
  add("value share", s.ppo.loss.valueWeight);
  add("entropy", s.ppo.loss.entropyWeight);
  add("discount", s.ppo.discount);
  add("lambda", s.ppo.lambda);
  add("passes", s.ppo.epochs);
  add("part", s.ppo.minibatch);
  add("rate", s.ppo.learningRate);
  add("most norm", s.ppo.maxGradNorm);
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
        fmt::format("made with another setting of '{}': {} then, {} now", name, before, after),
        "use the same options as before, or start again without --resume");
  };
  for (const Setting& s : now) OBBY_RETURN_IF_ERROR(differs(s.name));
  for (const Setting& s : then) OBBY_RETURN_IF_ERROR(differs(s.name));
  return {};
}

}  // namespace obby::train
