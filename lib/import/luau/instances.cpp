// What instances of the place answer to a script: children, properties, searches.
#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/classes/class_defaults.h"
#include "engine/values/materials.h"
#include "import/classes.h"
#include "import/luau/reader.h"
#include "import/pose_math.h"

namespace obby::importer::luau {
namespace {

constexpr size_t kChildrenPerStep = 8;  // looked through by name
constexpr size_t kClassesPerStep = 64;  // of children

Datum instanceOr(InstanceId id, const Datum& absent) {
  return id == kNoInstance ? absent : Datum{Ref{id}};
}

Datum materialOf(const Instance& part) {
  constexpr uint32_t kPlastic = 256;  // has no name as it is kept
  const uint32_t material = get<EnumItem>(part, "Material").value;
  const std::string name = material == kPlastic ? "Plastic" : std::string(materialName(material));
  return name.empty() ? Datum{} : Datum{Library{"Enum.Material." + name}};
}

// Lower-case and old spellings of properties.
std::string canonical(const std::string& name) {
  static const std::map<std::string, std::string> kOld = {
      {"position", "Position"},
      {"size", "Size"},
      {"cframe", "CFrame"},
      {"velocity", "Velocity"},
      {"parent", "Parent"},
      {"Rotation", "Orientation"},
      {"className", "ClassName"},
      {"AssemblyAngularVelocity", "RotVelocity"},
      {"AssemblyLinearVelocity", "Velocity"}};
  const auto it = kOld.find(name);
  return it == kOld.end() ? name : it->second;
}

}  // namespace

Datum Reader::serviceNamed(const std::string& name) const {
  const InstanceId service = tree_.service(name);
  if (service != kNoInstance) return {Ref{service}};
  if (const InstanceId root = tree_.rootNamed(name); root != kNoInstance) return {Ref{root}};
  if (name == "Workspace" || name == "workspace") return {Library{"workspace"}};
  return {Library{name}};
}

Datum Reader::instanceField(InstanceId id, const std::string& spelled) {
  const Instance& instance = tree_.at(id);
  const std::string name = canonical(spelled);
  if (name == "Parent") {
    if (instance.parent == kNoInstance) return {Library{"workspace"}};
    // What is in there is put into each new character.
    if (tree_.at(instance.parent).className == "StarterCharacterScripts")
      return {Stranger{"Character"}};
    return {Ref{instance.parent}};
  }
  if (name == "Name") return isTurned(id, name) ? Datum{} : Datum{instance.name};
  if (name == "ClassName") return {instance.className};
  if (tree_.isPart(id) && isPoseProperty(name)) {
    const auto moved = movedFrame(id);
    const Pose pose = tweenedFrame(id, moved ? *moved : fileFrame(id));
    const InstanceId from = moved ? kNoInstance : id;
    if (name == "CFrame") return {Frame{pose, from, id, statements_}};
    const bool place = name == "Position";
    const Vec3 value = place ? pose.position : toOrientation(pose.rotation);
    return isFinite(value) ? Datum{Vector{value, place ? from : kNoInstance}} : Datum{};
  }
  if (auto now = tweenedValue(id, name)) return *now;
  if ((name == "BrickColor" || name == "Color") && tree_.isPart(id)) return colorOf(id, name);
  if (auto now = writtenField(id, name)) return *now;
  // While the script sets the place up, as of a colour: traps change it as they wake.
  if (name == "Material" && tree_.isPart(id) && followed_ == 0 && !timeline_.forever)
    return materialOf(instance);
  if (auto kept = fileField(id, name)) return *kept;
  spend(instance.children.size() / kChildrenPerStep);
  const InstanceId child = tree_.child(id, spelled);
  if (child != kNoInstance) return {Ref{child}};
  if (instance.className == "Players") return {Stranger{name}};
  if (isA(instance.className, "Humanoid")) return {Stranger{name}};
  if (isSignalName(spelled)) return {Signal{id, nullptr, spelled}};
  return {};
}

// A property, or "@" and an attribute, as the script has set it; nothing: as the file has it.
std::optional<Datum> Reader::writtenField(InstanceId id, const std::string& name) {
  if (isTurned(id, name)) return Datum{};
  const auto set = written_.find({id, name});
  return set == written_.end() ? std::nullopt : std::optional<Datum>(set->second);
}

// The same as the file has it; nothing: there is no such property.
std::optional<Datum> Reader::fileField(InstanceId id, const std::string& name) const {
  const Instance& instance = tree_.at(id);
  if (name == "Name") return Datum{instance.name};
  if (name.rfind('@', 0) == 0) {
    const auto it = instance.attributes.find(name.substr(1));
    return it == instance.attributes.end() ? Datum{Nil{}} : datumFrom(it->second, kNoInstance);
  }
  const auto own = instance.properties.find(name);
  if (own != instance.properties.end()) return datumFrom(own->second, kNoInstance);
  const Value* value = defaultOf(instance.className, name);
  return value ? std::optional<Datum>(datumFrom(*value, kNoInstance)) : std::nullopt;
}

// While the script sets the place up: later on it, and other scripts, may turn it to and fro.
Datum Reader::colorOf(InstanceId id, const std::string& name) const {
  const bool numbered = name == "BrickColor";
  const bool otherwise = written_.count({id, numbered ? "Color" : "BrickColor"}) > 0;
  if (followed_ > 0 || timeline_.forever || otherwise) return {};
  const auto set = written_.find({id, name});
  if (set != written_.end()) return set->second;
  const auto color = get<ColorRgb>(tree_.at(id), "Color");
  return numbered ? numberedColor(color) : exactColor(color);
}

Datum Reader::children(InstanceId id, bool all) {
  auto list = arena_.make<Table>();
  const auto add = [&](InstanceId child) { list->items.push_back({Ref{child}}); };
  if (id == kNoInstance) {
    for (InstanceId root : tree_.document().roots) add(root);
  } else if (!all) {
    for (InstanceId child : tree_.at(id).children) add(child);
  } else {
    tree_.eachBelow(id, [&](InstanceId below) {
      if (below != id) add(below);
      return true;
    });
  }
  spend(list->items.size());
  return {list};
}

Datum Reader::instanceSearch(InstanceId id, const std::string& name,
                             const std::vector<Datum>& arguments, bool* handled) {
  *handled = true;
  const auto* text = argument(arguments, 0).as<std::string>();
  if (name == "GetChildren" || name == "children" || name == "getChildren")
    return children(id, false);
  if (name == "GetDescendants") return children(id, true);
  if (name == "GetTagged") {
    auto list = arena_.make<Table>();
    if (text) {
      tags_.push_back(*text);
      for (InstanceId tagged : tree_.tagged(*text)) list->items.push_back({Ref{tagged}});
      spend(list->items.size());
    }
    return {list};
  }
  const bool waits = name == "WaitForChild";
  if (waits || name == "FindFirstChild" || name == "findFirstChild") {
    if (!text) return {};
    if (id == kNoInstance) return serviceNamed(*text);
    spend(tree_.at(id).children.size() / kChildrenPerStep);
    InstanceId found = tree_.child(id, *text);
    if (found == kNoInstance && truthOf(argument(arguments, 1)) == Truth::yes && !waits)
      tree_.eachBelow(id, [&](InstanceId below) {
        if (!spend()) return false;
        if (found == kNoInstance && below != id && tree_.at(below).name == *text) found = below;
        return found == kNoInstance;
      });
    return instanceOr(found, waits ? Datum{} : Datum{Nil{}});
  }
  if (id == kNoInstance) {
    *handled = false;
    return {};
  }
  if (name == "FindFirstChildOfClass" || name == "FindFirstChildWhichIsA") {
    spend(tree_.at(id).children.size() / kClassesPerStep);
    for (InstanceId child : tree_.at(id).children)
      if (text && isA(tree_.at(child).className, *text)) return {Ref{child}};
    return {Nil{}};
  }
  if (name.rfind("FindFirstAncestor", 0) == 0) {
    size_t seen = 0;
    for (InstanceId up = tree_.at(id).parent; text && up != kNoInstance; up = tree_.at(up).parent) {
      if (++seen % kAncestorsPerStep == 0) spend();
      if (name == "FindFirstAncestor" ? tree_.at(up).name == *text
                                      : isA(tree_.at(up).className, *text))
        return {Ref{up}};
    }
    return {Nil{}};
  }
  *handled = false;
  return {};
}

Datum Reader::instanceMethod(InstanceId id, const std::string& name,
                             const std::vector<Datum>& arguments, int line) {
  bool handled = false;
  Datum found = instanceSearch(id, name, arguments, &handled);
  if (handled || id == kNoInstance) return found;
  const Instance& instance = tree_.at(id);
  if (instance.className == "Debris") return destroyLater(name, arguments, line);
  const Datum& first = argument(arguments, 0);
  const auto* text = first.as<std::string>();
  if (name == "IsA" || name == "isA") return text ? Datum{isA(instance.className, *text)} : Datum{};
  if (name == "IsDescendantOf" && first.as<Ref>()) {
    const InstanceId above = first.as<Ref>()->target;
    InstanceId up = instance.parent;
    for (size_t seen = 1; up != kNoInstance && up != above; up = tree_.at(up).parent)
      if (seen++ % kAncestorsPerStep == 0) spend();
    return {up == above};
  }
  if (name == "HasTag" && text)
    return {std::find(instance.tags.begin(), instance.tags.end(), *text) != instance.tags.end()};
  if (name == "SetAttribute" && text) {
    write(id, "@" + *text, argument(arguments, 1));
    return {};
  }
  if (name == "GetAttribute" && text) {
    const std::string key = "@" + *text;
    if (auto now = writtenField(id, key)) return *now;
    return fileField(id, key).value_or(Datum{});
  }
  const InstanceId own = tree_.isPart(id) ? id : kNoInstance;
  if (name == "GetPivot" || name == "GetPrimaryPartCFrame" || name == "GetModelCFrame") {
    const Pose pose = tweenedFrame(id, frameOf(id));
    return {Frame{name == "GetPivot" ? pose * pivotOffset(id) : pose, own}};
  }
  if (name == "PivotTo") {
    setPivot(id, first, line);
  } else if (name == "SetPrimaryPartCFrame") {
    setFrame(id, first, line);
  } else if (name == "MoveTo" || name == "TranslateBy") {
    Pose pose = frameOf(id);
    const auto* v = first.as<Vector>();
    if (v) pose.position = name == "MoveTo" ? v->value : pose.position + v->value;
    setFrame(id, v ? Datum{Frame{pose, v->from}} : Datum{}, line);
  } else if (name == "Destroy" || name == "destroy") {
    emit(EventKind::destroy, id, "Parent", line);
  } else if (name == "Remove" || name == "remove") {
    setParent(id, {Nil{}}, line);
  } else if (name == "ClearAllChildren" || name == "clearAllChildren") {
    clear(id, line);
  } else if (name == "Clone" || name == "clone") {
    auto made = arena_.make<Made>();
    made->className = instance.className;
    return {made};
  } else if (name == "GetTouchingParts" || name == "GetPartsInPart") {
    const auto* ref = name == "GetPartsInPart" ? first.as<Ref>() : nullptr;
    zone_ = ref ? ref->target : id;
    return {Stranger{"contents"}};
  } else if (name == "GetPlayers" || name == "GetPlayerFromCharacter" ||
             name == "getPlayerFromCharacter") {
    return {Stranger{"player"}};
  }
  return {};
}

Datum Reader::strangerMethod(const std::string& owner, const std::string& name,
                             const std::vector<Datum>& arguments, int line) {
  const Datum& first = argument(arguments, 0);
  const auto* state = first.as<Library>();
  const bool dies = name == "ChangeState" && state && state->name == "Enum.HumanoidStateType.Dead";
  if (name == "TakeDamage") {
    ScriptEvent& event = emit(EventKind::damage, kNoInstance, "Health", line);
    const auto* damage = first.as<double>();
    if (damage || !isAllHealth(first)) event.number = damage ? *damage : std::nan("");
  } else if (dies || name == "BreakJoints" || name == "breakJoints" || name == "LoadCharacter") {
    emit(EventKind::damage, kNoInstance, "Health", line);
  } else if (name == "PivotTo" || name == "MoveTo" || name == "SetPrimaryPartCFrame" ||
             name == "moveTo") {
    setStranger(owner, "CFrame", first, line);
  } else if (name == "SetAttribute" && first.as<std::string>()) {
    setStranger(*first.as<std::string>(), "Value", argument(arguments, 1), line);
  } else if (name == "ApplyImpulse") {
    setStranger(owner, "Velocity", {}, line);
  } else if (const auto* text = first.as<std::string>();
             text && (name.rfind("FindFirst", 0) == 0 || name == "WaitForChild" ||
                      name == "findFirstChild")) {
    return {Stranger{*text}};
  }
  return {Stranger{owner}};
}

Datum Reader::madeField(Made* made, const std::string& name) {
  const auto it = made->properties.find(name);
  return it == made->properties.end() ? Datum{} : it->second;
}

Datum Reader::newInstance(const std::vector<Datum>& arguments, int line) {
  const auto* className = argument(arguments, 0).as<std::string>();
  if (!className) return {};
  Made* made = arena_.make<Made>();
  made->className = *className;
  if (arguments.size() < 2) return {made};
  if (leadsToWorld(arguments[1]).value_or(false))
    setMade(made, "Parent", arguments[1], line);
  else
    made->properties["Parent"] = arguments[1];
  return {made};
}

Datum Reader::createTween(const std::vector<Datum>& arguments, int line) {
  auto tween = arena_.make<Tween>();
  tween->line = line;
  tween->number = ++tweens_;
  if (const auto* ref = arguments[0].as<Ref>()) tween->target = ref->target;
  const auto* timing = arguments[1].as<TweenTiming>();
  if (timing) tween->timing = *timing;
  tween->timing.known = timing && timing->known;
  if (const auto* goals = arguments[2].as<Table*>()) tween->goals = (*goals)->fields;
  return {tween};
}

// How far it is nobody knows that has not seen it played.
Datum Reader::tweenField(const Tween* tween, const std::string& name) {
  constexpr double kSlack = 2e-3;  // seconds
  if (name == "TweenInfo") return {tween->timing};
  if (name != "PlaybackState") return {};
  const bool goesOn = isPlaying(tween);
  const Played* last = lastPlayed(tween);
  if (!last || vague_ || last->doubt > unsure_) return {};
  const double since = time_ - last->time;
  const bool over = !last->stopped && since > tween->timing.total() - kSlack;
  const char* state = over ? "Completed" : "Cancelled";
  if (last->paused) state = "Paused";
  if (goesOn) state = since < tween->timing.delay - kSlack ? "Delayed" : "Playing";
  return {Library{std::string("Enum.PlaybackState.") + state}};
}

}  // namespace obby::importer::luau
