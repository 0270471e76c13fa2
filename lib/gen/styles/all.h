// One function for each row of the table; each in the file of its name.
#pragma once

#include "gen/sketch.h"

namespace obby::gen {

void buildWalkway(Sketch& s);
void buildGaps(Sketch& s);
void buildStairsUp(Sketch& s);
void buildStairsDown(Sketch& s);
void buildWall(Sketch& s);
void buildDoorway(Sketch& s);
void buildBeam(Sketch& s);
void buildKillFloor(Sketch& s);
void buildCheckerboard(Sketch& s);
void buildKillWall(Sketch& s);
void buildSpinner(Sketch& s);
void buildLogRoll(Sketch& s);
void buildSlider(Sketch& s);
void buildElevator(Sketch& s);
void buildCarrier(Sketch& s);
void buildConveyor(Sketch& s);
void buildIce(Sketch& s);
void buildWedge(Sketch& s);
void buildTruss(Sketch& s);
void buildJumpPad(Sketch& s);
void buildVanish(Sketch& s);
void buildBeat(Sketch& s);
void buildButton(Sketch& s);
void buildPushBlock(Sketch& s);
void buildFork(Sketch& s);
void buildDecoy(Sketch& s);
void buildZigzag(Sketch& s);
void buildSpiral(Sketch& s);

}  // namespace obby::gen
