// A trap that sleeps: its script is disabled in the file, and others may enable it.
#pragma once

#include <string>

#include "import/scene.h"

namespace obby::test {

inline constexpr const char* kMayHarm = "damage that a script may deal";
inline const std::string kKills =
    "script.Parent.Touched:Connect(function(hit)\nhit.Parent.Humanoid.Health = 0 end)";
inline const std::string kOn = "trap.Kill.Disabled = false ";

inline std::string pulled(const std::string& body) {
  return "lever.Touched:Connect(function() " + body + "end)";
}

// A trap with a disabled script `Kill`; other scripts call the parts `lever` and `trap`.
struct Sleeping : Scene {
  explicit Sleeping(const std::string& text = kKills) : kill(script(text, trap, "Kill")) {
    set(kill, "Disabled", true);
  }
  InstanceId run(const std::string& text, const std::string& name = "Enabler") {
    return script("local lever, trap = workspace.Lever, workspace.Trap " + text, scripts, name);
  }
  void sleeps(const std::string& text, const std::string& name) {
    set(run(text, name), "Disabled", true);
  }
  bool isGuessed(const std::string& role) const {
    return evidence(trap, role).rfind("guessed: script Kill line ", 0) == 0;
  }

  const InstanceId lever = part("Lever"), trap = part("Trap", {9, 0, 0});
  const InstanceId kill;
};

}  // namespace obby::test
