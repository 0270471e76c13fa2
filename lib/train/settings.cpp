#include "train/settings.h"

#include <fmt/format.h>

namespace obby::train {

std::vector<Setting> settingsOf(const TrainerSettings& s) {
  std::vector<Setting> out;
  const auto add = [&](const char* name, auto value) {
    out.push_back({name, fmt::format("{}", value)});
  };
  // Those with an option are called as the option is.
  add("seed", s.seed);
  add("worlds", s.crowds * s.crowd.levels * s.crowd.worlds);
  add("crowds", s.crowds);
  add("levels of a crowd", s.crowd.levels);
  add("playthroughs of a level", s.crowd.playthroughs);
  add("restart share", s.crowd.restarts.unsolved);
  add("restart share of solved levels", s.crowd.restarts.solved);
  add("patience", s.crowd.patience);
  add("reward of a stud", s.crowd.reward.stud);
  add("reward of the goal", s.crowd.reward.goal);
  add("reward of a death", s.crowd.reward.death);
  add("reward of a decision", s.crowd.reward.decision);
  add("reward of a jump", s.crowd.reward.jump);
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
