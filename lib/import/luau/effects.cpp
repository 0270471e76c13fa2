// What the assignments of a script do: events of the timeline.
#include <limits>

#include "import/classes.h"
#include "import/format/class_defaults.h"
#include "import/luau/reader.h"
#include "import/words.h"

namespace obby::importer::luau {
namespace {

// Value objects in which makers keep how far a player has come.
constexpr std::string_view kStageWords[] = {"stage", "checkpoint", "checkpoints", "level"};
// Movers that push what they are put into.
bool isPusher(const std::string& className) {
  return className == "BodyVelocity" || className == "LinearVelocity" || className == "BodyForce" ||
         className == "BodyThrust" || className == "VectorForce";
}

bool isCharacter(const Datum& datum) { return datum.as<Stranger>() || datum.as<Unknown>(); }

}  // namespace

ScriptEvent& Reader::emit(EventKind kind, InstanceId target, std::string property, int line) {
  ScriptEvent event;
  event.kind = kind;
  event.target = target;
  event.property = std::move(property);
  event.time = time_;
  event.line = line;
  event.unsure = unsure_ > 0;
  if (kind == EventKind::damage && timeline_.trigger != Trigger::touch) event.target = zone_;
  timeline_.events.push_back(std::move(event));
  return timeline_.events.back();
}

void Reader::write(InstanceId id, const std::string& name, Datum value) {
  const Key key{id, name};
  const auto it = written_.find(key);
  const auto old = it == written_.end() ? std::nullopt : std::optional<Datum>(it->second);
  if (inHandler_) beforeHandler_.try_emplace(key, old);
  if (timeline_.forever) beforeLoop_.try_emplace(key, old);
  written_[key] = std::move(value);
}

void Reader::setField(const Datum& object, const std::string& name, const Datum& value, int line) {
  if (const auto* ref = object.as<Ref>()) return setInstance(ref->target, name, value, line);
  if (const auto* made = object.as<Made*>()) return setMade(*made, name, value, line);
  if (const auto* table = object.as<Table*>()) {
    (*table)->fields[name] = value;
    return;
  }
  if (const auto* stranger = object.as<Stranger>())
    return setStranger(stranger->name, name, value, line);
  if (object.as<Unknown>()) setStranger("", name, value, line);
}

void Reader::setInstance(InstanceId id, const std::string& spelled, const Datum& value, int line) {
  std::string name = spelled;
  if (name == "AssemblyLinearVelocity" || name == "velocity") name = "Velocity";
  if (name == "AssemblyAngularVelocity") name = "RotVelocity";
  const Instance& instance = tree_.at(id);
  if (name == "Parent") {
    if (value.as<Nil>()) emit(EventKind::destroy, id, name, line);
    return;
  }
  if (isA(instance.className, "Humanoid")) return;  // an NPC
  if (tree_.isPart(id) && isPoseProperty(name))
    return setFrame(id, posed(frameOf(id), name, value), line);
  write(id, name, value);
  const auto* ref = value.as<Ref>();
  if (instance.className == "ObjectValue" && name == "Value" && ref && tree_.isPart(ref->target)) {
    emit(EventKind::respawnAt, ref->target, name, line);
    return;
  }
  ScriptEvent& event = emit(EventKind::set, id, name, line);
  if (const auto* number = value.as<double>()) event.number = *number;
  if (const auto* flag = value.as<bool>()) event.flag = *flag;
  if (const auto* vector = value.as<Vector>()) event.vector = vector->value;
}

void Reader::setStranger(const std::string& owner, const std::string& name, const Datum& value,
                         int line) {
  const auto* number = value.as<double>();
  if (name == "Health") {
    const auto* change = value.as<Change>();
    if (change && change->by < 0) {
      emit(EventKind::damage, kNoInstance, name, line).number = -change->by;
    } else if (number && *number <= 0) {
      emit(EventKind::damage, kNoInstance, name, line);
    }
    return;
  }
  const auto* vector = value.as<Vector>();
  if (name == "Velocity" || name == "AssemblyLinearVelocity" || name == "velocity") {
    ScriptEvent& event = emit(EventKind::push, kNoInstance, name, line);
    if (vector) event.vector = vector->value;
    return;
  }
  if (name == "CFrame" || name == "Position") {
    ScriptEvent& event = emit(EventKind::teleport, kNoInstance, name, line);
    if (const auto* frame = value.as<Frame>()) event.frame = frame->pose;
    if (vector) event.frame = Pose{vector->value, {}};
    return;
  }
  const bool stage = name == "Value" && !firstWordIn(owner, kStageWords).empty();
  const auto* ref = value.as<Ref>();
  const bool part = name == "Value" && ref && tree_.isPart(ref->target);
  if (stage || part || name == "RespawnLocation" || name == "TeamColor" || name == "Team") {
    ScriptEvent& event = emit(EventKind::respawnAt, part ? ref->target : kNoInstance, name, line);
    if (number) event.number = *number;
    return;
  }
  ScriptEvent& event = emit(EventKind::character, kNoInstance, name, line);
  if (number) event.number = *number;
  if (const auto* flag = value.as<bool>()) event.flag = *flag;
}

void Reader::setMade(Made* made, const std::string& name, const Datum& value, int line) {
  made->properties[name] = value;
  if (name == "Value" && isValueClass(made->className)) {  // a checkpoint kept in a value object
    const Datum label = madeField(made, "Name");
    const auto* called = label.as<std::string>();
    return setStranger(called ? *called : "", name, value, line);
  }
  const auto parent = made->properties.find("Parent");
  if (parent == made->properties.end()) return;
  if (isPusher(made->className) && isCharacter(parent->second)) {
    const bool velocity = name == "Velocity" || name == "velocity" || name == "VectorVelocity";
    const auto known = made->properties.find(
        made->properties.count("VectorVelocity") ? "VectorVelocity" : "Velocity");
    if (velocity)
      setStranger("", "Velocity", value, line);
    else if (name == "Parent" && known != made->properties.end())
      setStranger("", "Velocity", known->second, line);
    return;
  }
  const auto* ref = parent->second.as<Ref>();
  const bool buildable =
      isPartClass(made->className) || made->className == "Model" || made->className == "Folder";
  if (name == "Parent" && buildable && (ref || parent->second.as<Library>()))
    emit(EventKind::build, ref ? ref->target : kNoInstance, made->className, line);
}

}  // namespace obby::importer::luau
