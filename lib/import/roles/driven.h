// What constraints drive: the part that one moves against another which stands still, and the line
// on which a slider moves it.
#pragma once

#include <optional>
#include <string>

#include "import/motion.h"

namespace obby::importer {

// Values of the engine's ActuatorType.
constexpr uint32_t kMotor = 1, kServo = 2;
// Studs off its goal at which a slider has arrived.
constexpr double kArrived = 0.05;

struct Drive {
  InstanceId constraint = kNoInstance;
  InstanceId moving = kNoInstance;  // the part that is not held
  bool reversed = false;            // the moving part is the first end
  Pose frame;                       // world frame of the fixed attachment
};

// The end that moves, if exactly one end is held.
std::optional<Drive> driveOf(const RoleContext& context, InstanceId constraint);

// Gives a motion to `moving` and what moves with it; it carries. The evidence is the constraint's
// class and `what`. False if no part got it.
bool giveDriven(RoleContext& context, InstanceId moving, Motion motion, InstanceId constraint,
                const std::string& what, bool guessed);

// Anchors a part and what is joined to it, with `why` as evidence. False if nothing was loose.
bool hold(RoleContext& context, InstanceId part, const std::string& why);

// The line of a slider's moving part.
struct Track {
  Pose own;        // of the part, in the file
  Vec3 axis;       // world: the way that the position grows
  double now = 0;  // the position in the file

  Pose at(double position) const {
    return {own.position + axis * float(position - now), own.rotation};
  }
};
Track trackOf(const Tree& tree, const Drive& drive);

// Once from the place in the file to `position` at `speed`, and turning by `spin` for ever.
Motion slideTo(const Track& track, double position, double speed, const std::optional<Spin>& spin);

// A slider with a motor: to the limit, and there it stays. Where the file does not tell the way,
// the part is held, and the level names it. False if the motor drives nothing.
bool fromSliderMotor(RoleContext& context, const Drive& drive, const std::optional<Spin>& spin);

}  // namespace obby::importer
