// What constraints drive: the part that one moves against another, which stands still or goes its
// own way, and the line on which a slider moves it.
#pragma once

#include <optional>
#include <string>

#include "import/motion.h"
#include "import/roles/constraint_settings.h"

namespace obby::importer {

// Values of the engine's ActuatorType.
constexpr uint32_t kMotor = 1, kServo = 2;
// Studs off its goal at which a slider has arrived.
constexpr double kArrived = 0.05;

struct Drive {
  InstanceId constraint = kNoInstance;
  InstanceId base = kNoInstance, moving = kNoInstance;  // the part that is held, and the other
  bool reversed = false;                                // the moving part is the first end
  Pose frame;                                           // world frame of the fixed attachment
};

// The part that a constraint in OneAttachment mode or a legacy body mover acts on, or its first
// end; kNoInstance if there is none.
InstanceId movedPart(const Tree& tree, InstanceId id);

// The world frame in the file of an attachment of a constraint on `part`; without one, the part's.
Pose attachmentFrame(const Tree& tree, const Instance& constraint, const char* name,
                     InstanceId part);

// Whether nothing holds or moves the part so far.
bool isFree(RoleContext& context, InstanceId part);

// The ends, if exactly one is free.
std::optional<Drive> driveOf(RoleContext& context, InstanceId constraint);

// Whether the base of a drive moves by itself.
bool baseMoves(RoleContext& context, const Drive& drive);

// Gives a motion to `moving` and what moves with it; it carries. The evidence is the constraint's
// class and `what`. False if no part got it.
bool giveDriven(RoleContext& context, InstanceId moving, Motion motion, InstanceId constraint,
                const std::string& what, bool guessed);
// Of what a drive moves, with its base where scripts have placed that, or along with it. Where both
// go their own ways it is held, and the level names it.
bool giveDriven(RoleContext& context, const Drive& drive, Motion motion, const std::string& what,
                bool guessed);

// Anchors a part and what is joined to it, with `why` as evidence. False if nothing was loose.
bool hold(RoleContext& context, InstanceId part, const std::string& why);

// What is driven to where the file does not tell stands where the file has it, and the level names
// the constraint. False if nothing was loose.
bool leaveDriven(RoleContext& context, const char* kind, InstanceId part, InstanceId constraint,
                 const std::string& why);

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

// What a drive moves keeps its place, and turns by `spin` there. False if it is not in the level.
bool standStill(RoleContext& context, const Drive& drive, const std::optional<Spin>& spin);

// Once from the place in the file to `position` at `speed`, and turning by `spin` for ever.
Motion slideTo(const Track& track, double position, double speed, const std::optional<Spin>& spin);

// A slider with a motor: to the limit, and there it stays. Where the file does not tell the way,
// the part is held, and the level names it. False if the motor drives nothing.
bool fromSliderMotor(RoleContext& context, const ConstraintSettings& settings, const Drive& drive,
                     const std::optional<Spin>& spin);

}  // namespace obby::importer
