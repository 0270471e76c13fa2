// Runs a place with arbitrary scripts. The first byte selects the kind and place of a script, and a
// NUL begins the next script. A run ends within its budgets, and two runs give the same
// observation.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "engine/place.h"
#include "engine/stage.h"

namespace {

using namespace obby;

constexpr uint32_t kFrames = 90;
constexpr uint32_t kProbeFrames = 20;
constexpr size_t kMaxProbes = 6;
constexpr size_t kMaxScripts = 4;

engine::Settings settings() {
  engine::Settings settings;
  settings.budget = {.memory = size_t(32) << 20, .instructions = 3'000'000, .stretch = 300'000};
  settings.instances = 300;
  return settings;
}

// A place with parts to touch, a value, a ClickDetector, a prompt and a joint.
struct Scene : test::Place {
  Scene() {
    lava = part("Lava", {20, 0, 0});
    lift = part("Lift", {0, 5, 20});
    crate = part("Crate", {10, 2, 10});
    set(crate, "Anchored", false);
    detector = add("ClickDetector", "ClickDetector", lava);
    add("ProximityPrompt", "Prompt", lift);
    const InstanceId value = add("NumberValue", "Speed", workspace);
    set(value, "Value", 2.0);
    const InstanceId weld = add("WeldConstraint", "Weld", crate);
    set(weld, "Part0", Ref{crate});
    set(weld, "Part1", Ref{lift});
    player = add("StarterPlayer", "StarterPlayer", kNoInstance);
    local = add("StarterPlayerScripts", "StarterPlayerScripts", player);
    shared = add("ReplicatedStorage", "ReplicatedStorage", kNoInstance);
  }

  void addScripts(std::string_view text) {
    for (size_t i = 0; i < kMaxScripts && !text.empty(); ++i) {
      const size_t end = std::min(text.find('\0'), text.size());
      addScript(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  }

  // Adds a script. Its first letter selects the kind: l LocalScript, m ModuleScript, p a Script in
  // the lava, any other a Script in ServerScriptService.
  void addScript(std::string_view text) {
    if (text.empty()) return;
    const std::string source(text.substr(1));
    switch (text[0]) {
      case 'l': script(source, local, "LocalScript"); break;
      case 'm': script(source, shared, "ModuleScript"); break;
      case 'p': script(source, lava); break;
      default: script(source, scripts);
    }
  }

  InstanceId lava, lift, crate, detector, player, local, shared;
};

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "engine_fuzz: %s\n", what);
  std::abort();
}

// Writes an observation as text. Texts are equal if and only if the observations are.
class Summary {
 public:
  void add(double value) { text.append(reinterpret_cast<const char*>(&value), sizeof value); }
  void add(const std::string& value) { text.append(value), add(double(value.size())); }
  void add(Vec3 v) { add(double(v.x)), add(double(v.y)), add(double(v.z)); }
  void add(const Pose& pose) { add(pose.position), add(pose.rotation.x), add(pose.rotation.y); }
  void add(const engine::Plain& value) {
    std::visit([this](const auto& held) { addHeld(held); }, value);
  }
  void add(const engine::Observation& seen) {
    for (const engine::Change& change : seen.changes) {
      add(change.time), add(change.target), add(change.property), add(change.value);
      add(change.line.script), add(change.line.line);
    }
    for (const auto& [part, track] : seen.tracks) {
      add(part), add(track.line.line), add(track.driver);
      for (const engine::Placed& placed : track.poses) add(placed.frame), add(placed.pose);
    }
    for (const engine::Tween& tween : seen.tweens) add(tween.time), add(tween.target);
    for (const engine::Harm& harm : seen.harms) add(harm.time), add(harm.to);
    for (const engine::Problem& problem : seen.problems) add(problem.text), add(problem.count);
    for (const auto& [what, count] : seen.counts) add(what), add(count);
    add(seen.player.feet), add(seen.player.health), add(seen.player.walkSpeed);
  }

  std::string text;

 private:
  void addHeld(std::monostate) {}
  template <class T>
  void addHeld(const T& value) {
    add(value);
  }
};

// Returns the summary of a run.
std::string run(const Document& document) {
  const engine::Settings budget = settings();
  engine::Stage stage(document, budget);
  stage.start();
  stage.run(kFrames);
  stage.revive();
  std::vector<engine::Probe> probes = stage.probes();
  if (probes.size() > kMaxProbes) probes.resize(kMaxProbes);
  Summary summary;
  for (const engine::MadePart& part : stage.made()) {
    summary.add(part.id), summary.add(part.name);
    for (const auto& [name, value] : part.properties) summary.add(name), summary.add(value);
  }
  for (const engine::Probe& probe : probes) {
    if (probe.approach == engine::Approach::use) {
      stage.use(probe.target);
    } else {
      stage.standAt(probe.target, probe.approach == engine::Approach::inside, 0);
    }
    stage.run(kProbeFrames);
    stage.leave();
    stage.run(kProbeFrames);
  }
  const engine::Observation& seen = stage.observation();
  require(seen.frames <= kFrames + 2 * kProbeFrames * kMaxProbes, "it ran more frames than asked");
  require(stage.left() <= budget.budget.instructions, "it ran more instructions than it has");
  summary.add(seen);
  return summary.text;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Scene scene;
  scene.addScripts({reinterpret_cast<const char*>(data), size});
  const std::string first = run(scene.document);
  require(run(scene.document) == first, "the same place shows something else the second time");
  return 0;
}
