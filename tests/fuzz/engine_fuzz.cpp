// A place with scripts of any text. The first byte says what the script is and where it sits; a NUL
// begins another one. It ends within its budgets, and running it twice shows the same.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "engine/place.h"
#include "engine/report_bytes.h"
#include "engine/stage.h"

namespace {

using namespace obby;

constexpr uint32_t kFrames = 90;
constexpr uint32_t kProbeFrames = 20;
constexpr size_t kMostProbes = 6;
constexpr size_t kMostScripts = 4;

engine::Settings settings() {
  engine::Settings settings;
  settings.budget = {.memory = size_t(32) << 20, .instructions = 3'000'000, .stretch = 300'000};
  settings.instances = 300;
  return settings;
}

// Parts to touch, a value, a ClickDetector and a prompt, and a joint.
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
    for (size_t i = 0; i < kMostScripts && !text.empty(); ++i) {
      const size_t end = std::min(text.find('\0'), text.size());
      addScript(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  }

  // Letters: l LocalScript, m ModuleScript, p the lava's own; else a Script in its service.
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

// Everything that a run shows.
std::string run(const Document& document) {
  const engine::Settings budget = settings();
  engine::Stage stage(document, budget);
  stage.start();
  stage.run(kFrames);
  stage.revive();
  std::vector<engine::Probe> probes = stage.probes();
  if (probes.size() > kMostProbes) probes.resize(kMostProbes);
  std::string bytes = engine::toBytes(stage.made());
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
  engine::Observation seen = stage.observation();
  require(seen.frames <= kFrames + 2 * kProbeFrames * kMostProbes, "it ran more frames than asked");
  require(stage.left() <= budget.budget.instructions, "it ran more instructions than it has");
  // PlayerState has padding: its numbers one by one.
  engine::PlayerState& player = seen.player;
  engine::BytesOut out;
  out(player.feet), out(player.velocity), out(player.health), out(player.maxHealth);
  out(player.walkSpeed), out(player.jumpPower), out(player.jumpHeight), out(player.alive);
  out(seen.changes), out(seen.tracks), out(seen.tweens), out(seen.harms), out(seen.problems);
  out(seen.counts), out(seen.frames);
  return bytes + out.bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Scene scene;
  scene.addScripts({reinterpret_cast<const char*>(data), size});
  const std::string first = run(scene.document);
  require(run(scene.document) == first, "the same place shows something else the second time");
  return 0;
}
