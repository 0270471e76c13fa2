#include "import/observed/run.h"

#include <algorithm>
#include <map>
#include <vector>

#include "engine/classes/class_defaults.h"
#include "engine/observe.h"
#include "import/document/classes.h"
#include "import/observed/settle.h"
#include "import/observed/settled.h"

namespace obby::importer {
namespace {

// Returns the rig of the body that the script runtime gives players.
std::string rigOf(const Document& document) {
  for (const Instance& instance : document.instances)
    if (instance.className == "StarterPlayer")
      if (const auto* avatar = property<EnumItem>(instance, "GameSettingsAvatar"))
        return avatar->value == 1 ? "r15" : "r6";
  return "r6";
}

// Replaces the report's ids of parts that scripts made by the ids that they got in the document.
class Renumbering {
 public:
  explicit Renumbering(std::map<InstanceId, InstanceId> ids) : ids_(std::move(ids)) {}

  void apply(engine::Report& report) const {
    engine::eachObservation(report, [this](engine::Observation& seen) { apply(seen); });
    for (engine::MadePart& made : report.made) apply(made.id);
    for (engine::SameListeners& same : report.sameListeners) apply(same.target);
    for (engine::Probe& probe : report.probes) apply(probe.target);
    for (engine::Revisit& revisit : report.revisits) {
      apply(revisit.probe.target);
      apply(revisit.lever);
    }
  }

 private:
  void apply(InstanceId& id) const {
    const auto found = ids_.find(id);
    if (found != ids_.end()) id = found->second;
  }
  void apply(engine::Observation& seen) const {
    for (engine::Change& change : seen.changes) apply(change.target);
    for (engine::Tween& tween : seen.tweens) apply(tween.target);
    std::map<InstanceId, engine::Track> tracks;
    for (auto& [id, track] : seen.tracks) {
      InstanceId own = id;
      apply(own);
      apply(track.driver);
      tracks[own] = std::move(track);
    }
    seen.tracks = std::move(tracks);
  }

  std::map<InstanceId, InstanceId> ids_;
};

bool drawsRandomNumbers(const engine::Report& report) {
  bool draws = false;
  engine::eachObservation(report, [&](const engine::Observation& seen) { draws |= seen.random; });
  return draws;
}

ObservedPlace runPlace(const Document& document, const engine::Plan& plan) {
  ObservedPlace place;
  place.document = document;
  place.fromFile = document.instances.size();
  place.report = engine::observe(document, plan);
  place.ran = place.report.undisturbed.frames > 0;
  Renumbering(addMadeParts(place.document, place.report)).apply(place.report);
  place.brought = settle(place.document, place.report);
  place.settled = settledIn(document, place.document, place.report);
  return place;
}

}  // namespace

ObservedPlace observePlace(const Document& document) {
  const auto isScript = [](const Instance& one) { return isScriptClass(one.className); };
  if (std::none_of(document.instances.begin(), document.instances.end(), isScript))
    return {document, {}, false};
  engine::Plan plan;
  plan.settings.rig = rigOf(document);
  ObservedPlace place = runPlace(document, plan);
  if (!drawsRandomNumbers(place.report)) return place;
  // Low numbers show most of what high ones do. A large place takes long to run, so it runs again
  // only with low numbers.
  constexpr size_t kLarge = 200;  // parts that scripts listen to
  const size_t heard = place.report.probes.size() + place.report.sameListeners.size();
  using engine::Draws;
  std::vector<Draws> runs = {Draws::low};
  if (heard <= kLarge) runs = {Draws::low, Draws::high, Draws::even};
  for (const Draws draws : runs) {
    ++plan.settings.seed;
    plan.settings.draws = draws;
    ObservedPlace other = runPlace(document, plan);
    // A run that was cut short shows nothing about chance.
    if (other.report.failure.empty()) place.others.push_back(std::move(other));
  }
  return place;
}

}  // namespace obby::importer
