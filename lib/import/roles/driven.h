// Decides which parts constraints drive. A constraint moves one part against its base, which is at
// rest or moves by itself. A slider moves its part along a line.
#pragma once

#include <optional>
#include <string>

#include "import/draft/motion.h"
#include "import/roles/constraint_settings.h"

namespace obby::importer {

// Values of the engine's ActuatorType.
constexpr uint32_t kMotor = 1, kServo = 2;
// A slider has arrived if it is this close to its goal, in studs.
constexpr double kArrived = 0.05;

struct Drive {
  InstanceId constraint = kNoInstance;
  InstanceId base = kNoInstance, moving = kNoInstance;  // the part that is held, and the other one
  bool reversed = false;                                // the moving part is the first end
  Pose frame;                                           // world frame of the fixed attachment
};

// Returns the part on which a constraint in OneAttachment mode or a legacy body mover acts. For
// other constraints, returns the part at the first end. Returns kNoInstance if there is none.
InstanceId movedPart(const Tree& tree, InstanceId id);

// Returns the world frame in the file of a constraint's attachment on `part`. Without an
// attachment, returns the part's frame.
Pose attachmentFrame(const Tree& tree, const Instance& constraint, const char* name,
                     InstanceId part);

// Returns true if nothing holds or moves the part so far.
bool isFree(RoleContext& context, InstanceId part);

// Returns the ends, if exactly one is free.
std::optional<Drive> driveOf(RoleContext& context, InstanceId constraint);

// Returns true if the base of a drive moves by itself.
bool baseMoves(RoleContext& context, const Drive& drive);

// Gives a carrying motion to `moving` and all that moves with it. The evidence is the constraint's
// class and `what`. Returns false if no part got it.
bool giveDriven(RoleContext& context, InstanceId moving, Motion motion, InstanceId constraint,
                const std::string& what, bool guessed);
// Gives the moving part of a drive a motion relative to its base, which may move, too. If the two
// motions cannot be combined, the moving part is held, and the level notes it.
bool giveDriven(RoleContext& context, const Drive& drive, Motion motion, const std::string& what,
                bool guessed);

// Anchors a part and its joined parts, with `why` as evidence. Returns false if all of these were
// anchored already.
bool hold(RoleContext& context, InstanceId part, const std::string& why);

// Holds a part at its place in the file because the file does not state its destination. The level
// notes the constraint. Returns false if the part and its joined parts were anchored already.
bool leaveDriven(RoleContext& context, const char* kind, InstanceId part, InstanceId constraint,
                 const std::string& why);

// The line of a slider's moving part.
struct Track {
  Pose own;        // pose of the part in the file
  Vec3 axis;       // world direction in which the position grows
  double now = 0;  // position in the file

  Pose at(double position) const {
    return {own.position + axis * float(position - now), own.rotation};
  }
};
Track trackOf(const Tree& tree, const Drive& drive);

// Keeps the part of a drive in place, and turns it by `spin`. Returns false if it is not in the
// level.
bool standStill(RoleContext& context, const Drive& drive, const std::optional<Spin>& spin);

// Returns a motion that goes once from the place in the file to `position` at `speed`, and turns by
// `spin` for ever.
Motion slideTo(const Track& track, double position, double speed, const std::optional<Spin>& spin);

// Moves a slider with a motor to its limit, where it stays. If the file does not state where it
// stops, the part is held, and the level notes it. Returns false if the motor drives nothing.
bool fromSliderMotor(RoleContext& context, const ConstraintSettings& settings, const Drive& drive,
                     const std::optional<Spin>& spin);

}  // namespace obby::importer
