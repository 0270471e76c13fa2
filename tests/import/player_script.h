// Adds scripts of the player to a scene.
#pragma once

#include <string>

#include "import/scene.h"

namespace obby::test {

// Adds a LocalScript to a folder of StarterPlayer: StarterPlayerScripts, or StarterCharacterScripts
// for a script of each new body.
inline void localScript(Scene& scene, const std::string& folder, const std::string& source) {
  const auto player = scene.add("StarterPlayer", "StarterPlayer", kNoInstance);
  const auto script = scene.add("LocalScript", "Local", scene.add(folder, folder, player));
  scene.set(script, "Source", source);
}

// Adds a spawn and a LocalScript. In StarterCharacterScripts the script has the local variable
// `human`.
inline void playerScript(Scene& scene, const std::string& folder, const std::string& source) {
  scene.part("SpawnLocation", {}, scene.workspace, "SpawnLocation");
  localScript(scene, folder, source);
}
inline void bodyScript(Scene& scene, const std::string& source) {
  playerScript(scene, "StarterCharacterScripts",
               "local human = script.Parent:WaitForChild('Humanoid')\n" + source);
}

}  // namespace obby::test
