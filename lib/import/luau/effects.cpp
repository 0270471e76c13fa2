// What the assignments of a script do: events of the timeline.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/classes/class_defaults.h"
#include "import/classes.h"
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

// What scripts put into the world and take out of it that may be solid.
bool isBuildable(const std::string& className) {
  return isPartClass(className) || className == "Model" || className == "Folder";
}

// Services that are no part of the world, as a place without them names them.
constexpr std::string_view kStorages[] = {
    "Lighting",   "Players",     "ReplicatedFirst",     "ReplicatedStorage",
    "StarterGui", "StarterPack", "ServerScriptService", "ServerStorage"};
constexpr int kMaxMade = 16;          // folders that a script makes, one in the other
constexpr double kDebris = 10;        // seconds that Debris keeps what it is given
constexpr double kNever = 1e6;        // seconds
constexpr size_t kStepsOfAChild = 4;  // that is removed with all its like

// The number of an ActuatorType, which scripts give as an item of the enum or as its name.
std::optional<double> actuatorOf(const std::string& property, const Datum& value) {
  constexpr std::string_view kTypes[] = {"None", "Motor", "Servo"};
  if (property != "ActuatorType" && property != "AngularActuatorType") return std::nullopt;
  const auto* item = value.as<Library>();
  const auto* text = value.as<std::string>();
  if (!item && !text) return std::nullopt;
  const std::string name = text ? *text : item->name.substr(item->name.rfind('.') + 1);
  for (size_t i = 0; i < std::size(kTypes); ++i)
    if (name == kTypes[i]) return double(i);
  return std::nullopt;
}

// Who touches what explodes is harmed, but where it is for show.
bool explodes(const Made& made) {
  const auto isNone = [&](const char* name) {
    const auto set = made.properties.find(name);
    const auto* number = set == made.properties.end() ? nullptr : set->second.as<double>();
    return number && *number == 0;
  };
  return made.className == "Explosion" && !isNone("DestroyJointRadiusPercent") &&
         !isNone("BlastRadius");
}

bool isCharacter(const Datum& datum) { return datum.as<Stranger>() || datum.as<Unknown>(); }

}  // namespace

ScriptEvent& Reader::emit(EventKind kind, InstanceId target, std::string property, int line) {
  ScriptEvent& event = room_.addTo(timeline_.events);
  event.kind = kind;
  event.target = target;
  event.property = std::move(property);
  event.time = time_;
  event.line = line;
  event.unsure = isUnsure();
  if (kind == EventKind::damage && timeline_.trigger != Trigger::touch) event.target = zone_;
  return event;
}

void Reader::write(InstanceId id, const std::string& name, Datum value) {
  const Key key{id, name};
  const auto it = written_.find(key);
  const auto old = it == written_.end() ? std::nullopt : std::optional<Datum>(it->second);
  if (inHandler_) beforeHandler_.try_emplace(key, old);
  if (timeline_.forever) beforeLoop_.try_emplace(key, old);
  noteTurn(id, name, old, value);
  noteChange(id, name, value);
  written_[key] = std::move(value);
}

void Reader::setField(const Datum& object, const std::string& name, const Datum& value, int line) {
  if (const auto* ref = object.as<Ref>()) return setInstance(ref->target, name, value, line);
  if (const auto* made = object.as<Made*>()) return setMade(*made, name, value, line);
  if (const auto* table = object.as<Table*>())
    return variables_.set((*table)->fields, name, value, isOwn((*table)->born));
  if (const auto* stranger = object.as<Stranger>())
    return setStranger(stranger->name, name, value, line);
  if (object.as<Unknown>()) setStranger("", name, value, line);
}

void Reader::setInstance(InstanceId id, const std::string& spelled, const Datum& value, int line) {
  if (spelled.size() > kLongestKey) return;  // no property is called so: the engine stops there
  std::string name = spelled;
  if (name == "AssemblyLinearVelocity" || name == "velocity") name = "Velocity";
  if (name == "AssemblyAngularVelocity") name = "RotVelocity";
  if (name == "maxForce" || name == "maxTorque") name[0] = 'M';
  const Instance& instance = tree_.at(id);
  if (name == "Parent" || name == "parent") return setParent(id, value, line);
  if (isA(instance.className, "Humanoid")) return;  // an NPC
  if (tree_.isPart(id) && isPoseProperty(name)) {
    const auto* frame = value.as<Frame>();
    // `part.CFrame * CFrame.Angles(...)` leaves the part where it is by then; a pose that was kept
    // in a variable brings it back.
    const bool stays = frame && frame->at == id && frame->statement == statements_;
    const Pose last = frameOf(id);  // where tweens leave it
    Datum pose = posed(last, name, value);
    if (stays && going_.count({id, "CFrame"}) > 0)
      pose = {Frame{{last.position, frame->pose.rotation}, frame->from}};
    ScriptEvent& moved = setFrame(id, pose, line);
    moved.places = setsPlace(name) && !stays;
    moved.turns = setsTurn(name);
    return;
  }
  // A colour that a branch may not set is the old or the new one; that of a light turns in play.
  const bool told = !isColor(value) || (tree_.isPart(id) && !isUnsure());
  write(id, name, told ? value : Datum{});
  const auto* ref = value.as<Ref>();
  if (instance.className == "ObjectValue" && name == "Value" && ref && tree_.isPart(ref->target)) {
    emit(EventKind::respawnAt, ref->target, name, line);
    return;
  }
  ScriptEvent& event = emit(EventKind::set, id, name, line);
  event.number = actuatorOf(name, value);
  if (const auto* number = value.as<double>()) event.number = *number;
  if (const auto* flag = value.as<bool>()) event.flag = *flag;
  if (const auto* vector = value.as<Vector>()) event.vector = vector->value;
}

// What is in something that was taken out of the world is out, too.
bool Reader::isInWorld(InstanceId id) {
  InstanceId root = id;
  size_t seen = 0;
  for (InstanceId up = id; up != kNoInstance; up = tree_.at(up).parent) {
    if (++seen % kAncestorsPerStep == 0) spend();
    const auto set = written_.find({up, "Parent"});
    const auto* inside = set == written_.end() ? nullptr : set->second.as<bool>();
    if (inside) return *inside;
    root = up;
  }
  const InstanceId workspace = tree_.service("Workspace");  // none: all of a model file is in it
  return workspace == kNoInstance || root == workspace;
}

// Whether what has this parent is in the world; nothing: the text does not tell.
std::optional<bool> Reader::leadsToWorld(const Datum& parent) {
  const Datum* at = &parent;
  for (int i = 0; i < kMaxMade; ++i) {
    const auto* made = at->as<Made*>();
    if (!made) break;
    const auto up = (*made)->properties.find("Parent");
    if (up == (*made)->properties.end()) return std::nullopt;
    at = &up->second;
  }
  if (at->as<Nil>()) return false;
  if (const auto* ref = at->as<Ref>()) return isInWorld(ref->target);
  const auto* library = at->as<Library>();
  if (!library) return std::nullopt;
  if (library->name == "workspace") return true;
  const bool stores =
      std::find(std::begin(kStorages), std::end(kStorages), library->name) != std::end(kStorages);
  return stores ? std::optional<bool>(false) : std::nullopt;
}

// What is kept under "Parent" is whether it is in the world.
void Reader::setParent(InstanceId id, const Datum& parent, int line) {
  const auto inside = leadsToWorld(parent);
  if (!inside) {
    emit(EventKind::set, id, "Parent", line);
    return;
  }
  const bool was = isInWorld(id), wasSet = written_.count({id, "Parent"}) > 0;
  write(id, "Parent", {*inside});
  if (!*inside) {
    emit(EventKind::destroy, id, "Parent", line);
  } else if (!was && !wasSet) {  // out of storage: the level has nothing of it
    const auto* ref = parent.as<Ref>();
    const std::string& className = tree_.at(id).className;
    if (isBuildable(className))
      emit(EventKind::build, ref ? ref->target : kNoInstance, className, line);
  } else if (!was || timeline_.forever || (inHandler_ && tree_.isPart(id))) {
    // In a loop it may have left in the round before, in a handler by what stands below.
    emit(EventKind::set, id, "Parent", line).flag = true;
  }
}

void Reader::clear(InstanceId id, int line) {
  const auto& children = tree_.at(id).children;
  spend(children.size() * kStepsOfAChild);
  for (InstanceId child : children)
    if (tree_.isPart(child) || !tree_.at(child).children.empty())
      emit(EventKind::destroy, child, "Parent", line);
}

// Debris:AddItem: something is destroyed after so many seconds.
Datum Reader::destroyLater(const std::string& method, const std::vector<Datum>& arguments,
                           int line) {
  const auto* ref = argument(arguments, 0).as<Ref>();
  if (!ref || (method != "AddItem" && method != "addItem")) return {};
  const auto* seconds = argument(arguments, 1).as<double>();
  if (arguments.size() > 1 && (!seconds || std::isnan(*seconds))) {
    emit(EventKind::set, ref->target, "Parent", line);  // sooner or later
    return {};
  }
  const double delay = seconds ? std::max(*seconds, 0.0) : kDebris;
  if (delay < kNever) emit(EventKind::destroy, ref->target, "Parent", line).time += delay;
  return {};
}

void Reader::setStranger(const std::string& owner, const std::string& name, const Datum& value,
                         int line) {
  if (name.size() > kLongestKey) return;  // as of an instance
  const auto* number = value.as<double>();
  if (name == "Health") {
    const auto* change = value.as<Change>();
    if (change && !(change->by >= 0)) {
      emit(EventKind::damage, kNoInstance, name, line).number = -change->by;
    } else if (number && *number <= 0) {
      emit(EventKind::damage, kNoInstance, name, line);
    } else if (value.as<Unknown>()) {
      emit(EventKind::character, kNoInstance, name, line);
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
  if (name == "Parent" && explodes(*made) && leadsToWorld(value).value_or(true))
    emit(EventKind::character, kNoInstance, "Health", line);
  const auto* ref = parent->second.as<Ref>();
  if (name == "Parent" && isBuildable(made->className) && (ref || parent->second.as<Library>()))
    emit(EventKind::build, ref ? ref->target : kNoInstance, made->className, line);
}

}  // namespace obby::importer::luau
