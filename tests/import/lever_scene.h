// A lever and a trap, for tests of how one touch affects the next.
#pragma once

#include <string>

#include "import/motion_checks.h"

namespace obby::test {

inline constexpr const char* kMoreLater = "touch with a later effect";
inline constexpr const char* kLessLater = "touch whose effect wears off";
inline const std::string kKillHit = "hit.Parent.Humanoid.Health = 0 ";

// Scripts can use the parts `lever` and `p` (the trap). The trap contains three values.
struct LeverScene : Scene {
  LeverScene() {
    add("ClickDetector", "ClickDetector", lever);
    value("BoolValue", "On", false, trap);
    value("NumberValue", "Count", 0.0, trap);
    value("StringValue", "Mode", std::string("calm"), trap);
  }
  InstanceId run(const std::string& text, bool onClient = false) {
    const InstanceId id =
        add(onClient ? "LocalScript" : "Script", "Script", onClient ? client : scripts);
    set(id, "Source", "local lever, p = workspace.Lever, workspace.Trap\n" + text);
    return id;
  }
  void pulls(const std::string& does, bool onClient = false) {
    run("lever.Touched:Connect(function() " + does + " end)", onClient);
  }
  void asks(const std::string& condition, bool onClient = false) {
    run("p.Touched:Connect(function(hit) if " + condition + " then\n" + kKillHit + "end end)",
        onClient);
  }

  const InstanceId lever = part("Lever", {20, 0, 0}), trap = part("Trap", {40, 0, 0});
  const InstanceId client = add("StarterPlayerScripts", "StarterPlayerScripts",
                                add("StarterPlayer", "StarterPlayer", kNoInstance));
};

inline bool isGuessedKill(const Scene& scene, InstanceId part) {
  return scene.evidence(part, "kill").rfind("guessed: ", 0) == 0;
}

inline std::string noteOf(const LevelDraft& level, const char* kind) {
  const auto found = level.unmodelled.find(kind);
  return found == level.unmodelled.end() ? "" : found->second.note;
}

// Expects that the trap harms, and that the level states the condition.
inline void expectArmed(LeverScene& scene, const std::string& what,
                        const std::string& when = "once 'Lever' has been touched or used") {
  scene.level();
  EXPECT_FALSE(scene[scene.lever].kill) << what;
  ASSERT_TRUE(scene[scene.trap].kill) << what;
  EXPECT_GE(scene[scene.trap].kill->damage, 100) << what;
  EXPECT_TRUE(isGuessedKill(scene, scene.trap)) << what;
  ASSERT_EQ(scene.unmodelled(kMoreLater), 1u) << what;
  EXPECT_EQ(scene.level().unmodelled.at(kMoreLater).example, "Workspace/Trap") << what;
  EXPECT_EQ(noteOf(scene.level(), kMoreLater).rfind(when, 0), 0u)
      << what << noteOf(scene.level(), kMoreLater);
}

inline void expectHarmless(LeverScene& scene, const std::string& what) {
  scene.level();
  EXPECT_FALSE(scene[scene.trap].kill) << what;
  EXPECT_EQ(scene.unmodelled(kMoreLater), 0u) << what;
}

}  // namespace obby::test
