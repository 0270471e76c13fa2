#include "baselines/device_players.h"

#include <algorithm>

#include "base/check.h"
#include "baselines/cuda/cuda.h"

namespace obby::baselines {

Status DevicePlayers::open(sim::Device& device, const Problem& problem,
                           const policy::SurroundingsView& around, uint32_t most) {
  device_ = &device;
  actions_.resize(most);
  sim::Course course;
  course.levels = {problem.level};
  course.queries = {problem.query};
  course.starts = {problem.start};
  course.starts[0].outcome = sim::Outcome::running;  // so that worlds can run
  OBBY_ASSIGN(batch_, sim::makeKernelBatch(course, most, device));
  sight_.rules = {problem.level, problem.query, around};
  OBBY_ASSIGN(tables_, sim::uploadTables(device, sight_.rules));
  return {};
}

// Steps all worlds of the batch. Results beyond the episodes are ignored.
Status DevicePlayers::advance(std::span<Episode* const> episodes, const sim::Action* actions) {
  OBBY_CHECK_LE(episodes.size(), actions_.size());
  if (episodes.empty()) return {};
  std::vector<sim::World> worlds;
  std::vector<sim::LooseBody> loose;
  for (const Episode* e : episodes) {
    worlds.push_back(e->world);
    loose.insert(loose.end(), e->loose.begin(), e->loose.end());
  }
  std::copy_n(actions, episodes.size(), actions_.begin());
  OBBY_RETURN_IF_ERROR(batch_->restore(0, worlds, loose));
  OBBY_RETURN_IF_ERROR(batch_->step(1, sim::Actions::tabulated(actions_)));
  OBBY_ASSIGN(worlds, batch_->worlds());
  OBBY_ASSIGN(loose, batch_->loose());
  const size_t bodies = sight_.rules.level.looseCount;
  for (size_t i = 0; i < episodes.size(); ++i) {
    episodes[i]->world = worlds[i];
    std::copy_n(loose.data() + i * bodies, bodies, episodes[i]->loose.data());
  }
  return {};
}

Status DevicePlayers::see(std::span<const View> views, float* inputs, size_t stride) {
  std::vector<Looker> lookers;
  std::vector<sim::LooseBody> loose;
  for (const View& v : views) {
    lookers.push_back({v.player->world, v.next, v.ahead});
    loose.insert(loose.end(), v.player->loose.begin(), v.player->loose.end());
  }
  OBBY_RETURN_IF_ERROR(sim::uploadTable<Looker>(*device_, lookerMemory_, lookers));
  OBBY_RETURN_IF_ERROR(sim::uploadTable<sim::LooseBody>(*device_, looseMemory_, loose));
  inputs_.resize(views.size() * policy::kInputs);
  OBBY_RETURN_IF_ERROR(sim::makeRoom(*device_, inputMemory_, sight_.inputs, inputs_.size()));
  sight_.players = lookerMemory_.as<Looker>();
  sight_.loose = looseMemory_.as<sim::LooseBody>();
  static const sim::Kernel kernel =
      sim::makeKernel<SightArguments, seePart>("learnedSee", cuda::sightEntry());
  OBBY_RETURN_IF_ERROR(
      device_->launch(kernel, &sight_, uint32_t(views.size()) * policy::kViewThreads));
  OBBY_RETURN_IF_ERROR(
      device_->download(inputs_.data(), sight_.inputs, inputs_.size() * sizeof(float)));
  for (size_t i = 0; i < views.size(); ++i)
    std::copy_n(inputs_.data() + i * policy::kInputs, policy::kInputs, inputs + i * stride);
  return {};
}

}  // namespace obby::baselines
