// Where parts and models are at the point that the reading has come to, and what moves them.
#include "engine/classes/class_defaults.h"
#include "import/luau/reader.h"
#include "import/pivot.h"
#include "import/pose_math.h"

namespace obby::importer::luau {
namespace {

bool isKnown(const Pose& pose) {
  const Mat3& r = pose.rotation;
  return isFinite(pose.position) && isFinite(r.x) && isFinite(r.y) && isFinite(r.z);
}

}  // namespace

const Pose* Reader::writtenFrame(InstanceId id) const {
  const auto it = written_.find({id, "CFrame"});
  const auto* frame = it == written_.end() ? nullptr : it->second.as<Frame>();
  return frame ? &frame->pose : nullptr;
}

const Pose& Reader::fileFrame(InstanceId id) {
  const auto it = fileFrames_.find(id);
  if (it != fileFrames_.end()) return it->second;
  return fileFrames_.emplace(id, pivotOf(tree_, id)).first->second;
}

// What is below a model goes where the model does.
std::optional<Pose> Reader::movedFrame(InstanceId id) {
  const InstanceId primary = primaryPartOf(tree_, id);
  if (primary != kNoInstance)
    if (const Pose* moved = writtenFrame(primary)) return *moved;
  if (const Pose* moved = writtenFrame(id)) return *moved;
  size_t seen = 0;
  for (InstanceId up = tree_.at(id).parent; up != kNoInstance; up = tree_.at(up).parent) {
    if (++seen % kAncestorsPerStep == 0) spend();
    const Pose* moved = tree_.isPart(up) ? nullptr : writtenFrame(up);
    if (moved) return *moved * inverse(fileFrame(up)) * fileFrame(id);
  }
  return std::nullopt;
}

Pose Reader::frameOf(InstanceId id) {
  const auto moved = movedFrame(id);
  return moved ? *moved : fileFrame(id);
}

Pose Reader::pivotOffset(InstanceId id) const {
  const InstanceId part = tree_.isPart(id) ? id : primaryPartOf(tree_, id);
  return part == kNoInstance ? Pose{} : get<CFrame>(tree_.at(part), "PivotOffset");
}

ScriptEvent& Reader::setFrame(InstanceId id, const Datum& value, int line) {
  ScriptEvent& event = emit(EventKind::set, id, "CFrame", line);
  const auto* frame = value.as<Frame>();
  if (!frame || !isKnown(frame->pose)) return event;
  event.frame = frame->pose;
  event.from = frame->from;
  if (!tree_.isPart(id)) takeAlong(id, frame->pose * inverse(frameOf(id)));
  write(id, "CFrame", {Frame{frame->pose, kNoInstance}});
  return event;
}

void Reader::setPivot(InstanceId id, const Datum& value, int line) {
  const auto* frame = value.as<Frame>();
  Datum pose;
  if (frame) pose = {Frame{frame->pose * inverse(pivotOffset(id)), frame->from}};
  setFrame(id, pose, line);
}

// Poses below a model that were set on their own keep their place in it.
void Reader::takeAlong(InstanceId model, const Pose& by) {
  spend(written_.size());
  std::vector<std::pair<InstanceId, Pose>> below;
  for (const auto& [key, value] : written_) {
    const auto* frame = key.second == "CFrame" ? value.as<Frame>() : nullptr;
    if (frame && key.first != model && tree_.isUnder(key.first, model))
      below.push_back({key.first, by * frame->pose});
  }
  for (const auto& [id, pose] : below) write(id, "CFrame", {Frame{pose, kNoInstance}});
}

bool isPoseProperty(const std::string& name) {
  const std::string plain = lower(name);
  return plain == "cframe" || plain == "position" || name == "Orientation" || name == "Rotation";
}

bool setsPlace(const std::string& poseProperty) {
  const std::string plain = lower(poseProperty);
  return plain == "cframe" || plain == "position";
}

bool setsTurn(const std::string& poseProperty) { return lower(poseProperty) != "position"; }

Datum posed(Pose pose, const std::string& name, const Datum& value) {
  if (lower(name) == "cframe") return value;
  const auto* vector = value.as<Vector>();
  if (!vector) return {};
  if (lower(name) == "position")
    pose.position = vector->value;
  else
    pose.rotation = fromOrientation(vector->value);
  return {Frame{pose, vector->from}};
}

// The goals of one tween that make up a pose are reached together: one event.
void Reader::setPoseGoals(const Tween& tween, int line) {
  std::optional<Datum> goal;
  std::optional<Vec3> orientation;
  InstanceId from = kNoInstance;
  bool places = false, turns = false;
  for (const auto& [name, value] : tween.goals) {
    if (!isPoseProperty(name)) continue;
    places = places || setsPlace(name);
    turns = turns || setsTurn(name);
    const auto* before = goal ? goal->as<Frame>() : nullptr;
    if (goal && !before) break;  // one of them is not known
    goal = posed(before ? before->pose : frameOf(tween.target), name, value);
    if (const auto* frame = goal->as<Frame>(); frame && from == kNoInstance) from = frame->from;
    const auto* turned = lower(name) == "position" ? nullptr : value.as<Vector>();
    if (turned) orientation = turned->value;
  }
  if (!goal) return;
  const auto* frame = goal->as<Frame>();
  ScriptEvent& event =
      setFrame(tween.target, frame ? Datum{Frame{frame->pose, from}} : *goal, line);
  event.orientation = orientation;
  event.places = places;
  event.turns = turns;
}

}  // namespace obby::importer::luau
