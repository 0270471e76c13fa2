// The styles of the table. Each is defined in the file of its name.
#pragma once

#include "gen/sketch.h"
#include "gen/style.h"

namespace obby::gen {

extern const Style kWalkwayStyle, kGapsStyle, kStairsUpStyle, kStairsDownStyle, kWallStyle,
    kDoorwayStyle, kBeamStyle, kKillFloorStyle, kCheckerboardStyle, kKillWallStyle, kSpinnerStyle,
    kLogRollStyle, kSliderStyle, kElevatorStyle, kCarrierStyle, kConveyorStyle, kIceStyle,
    kWedgeStyle, kTrussStyle, kJumpPadStyle, kVanishStyle, kBeatStyle, kButtonStyle,
    kPushBlockStyle, kForkStyle, kDecoyStyle, kZigzagStyle, kSpiralStyle;

}  // namespace obby::gen
