#include "gen/styles.h"

#include "gen/styles/all.h"

namespace obby::gen {

const std::vector<Style>& styles() {
  static const std::vector<Style> table = {
      {"walkway", "long walkways with turns, narrower the harder", buildWalkway},
      {"gaps", "stones with air between them", buildGaps},
      {"stairs-up", "steps to jump up", buildStairsUp},
      {"stairs-down", "drops onto ever smaller steps", buildStairsDown},
      {"wall", "walls to jump over", buildWall},
      {"doorway", "walls with a gap to find", buildDoorway},
      {"beam", "thin beams", buildBeam},
      {"kill-floor", "stones over lava", buildKillFloor},
      {"checkerboard", "safe and deadly tiles in turn", buildCheckerboard},
      {"kill-wall", "low walls of lava to jump", buildKillWall},
      {"spinner", "deadly bars that turn over a disc", buildSpinner},
      {"log-roll", "along a log round which spikes turn", buildLogRoll},
      {"slider", "platforms that slide from side to side", buildSlider},
      {"elevator", "platforms that rise to a ledge beyond a jump", buildElevator},
      {"carrier", "a platform that carries the player through doors", buildCarrier},
      {"conveyor", "belts against, across and along the way", buildConveyor},
      {"ice", "slippery lanes and corners", buildIce},
      {"wedge", "ramps up and down", buildWedge},
      {"truss", "towers to climb by a truss", buildTruss},
      {"jump-pad", "pads that throw the player up to a ledge", buildJumpPad},
      {"vanish", "a run over tiles that disappear when touched", buildVanish},
      {"beat", "platforms that come and go to a beat", buildBeat},
      {"button", "buttons that open a door or make a bridge for a while", buildButton},
      {"push-block", "a block to push to a wall that is too high", buildPushBlock, false, true},
      {"fork", "several routes side by side", buildFork, false, false, true},
      {"decoy", "a road to nowhere, and the way round", buildDecoy, false, true, true},
      {"zigzag", "stones to this side and that, up and down", buildZigzag},
      {"spiral", "ledges that wind up a core", buildSpiral, false, false, true},
      {"course", "several of the others in a row, ever harder", nullptr, true},
  };
  return table;
}

const Style* findStyle(std::string_view name) {
  for (const Style& s : styles()) {
    if (name == s.name) return &s;
  }
  return nullptr;
}

}  // namespace obby::gen
