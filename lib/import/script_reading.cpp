// Which scripts of a place run, and their readings: all of them, then those that others enable, and
// then once more those whose handlers have asked for what others set.
#include "import/script_reading.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "engine/classes/class_defaults.h"
#include "engine/luau/parser.h"
#include "import/classes.h"
#include "import/luau/changes.h"
#include "import/luau/reader.h"
#include "import/script_side.h"
#include "import/woken_scripts.h"
#include "import/words.h"

namespace obby::importer {
namespace {

constexpr size_t kMaxSource = 1 << 20;  // bytes; larger texts are data, not scripts
constexpr size_t kScriptSteps = 1000000, kPlaceSteps = 20000000;
static_assert(kScriptRoom * sizeof(ScriptEvent) <= (size_t{512} << 20), "see kScriptRoom");
static_assert(sizeof(Timeline) <= sizeof(ScriptEvent), "takes as much of the room");
// What a script that joins parts has in its text.
constexpr std::string_view kJointWords[] = {"Weld", "MakeJoints", "Motor6D", "Constraint"};

bool isDisabled(const Instance& script) {
  return propertyOr(script, "Disabled", false) || !propertyOr(script, "Enabled", true);
}

InstanceId rootOf(const Tree& tree, InstanceId id) {
  while (tree.at(id).parent != kNoInstance) id = tree.at(id).parent;
  return id;
}

// True if the engine starts the script by itself, unless it is disabled.
bool canRun(const Tree& tree, InstanceId id) {
  const Instance& script = tree.at(id);
  if (script.className == "ModuleScript") return false;
  const std::string& root = tree.at(rootOf(tree, id)).className;
  const auto* context = property<EnumItem>(script, "RunContext");
  if (context && (context->value == kRunClient || context->value == kRunServer))
    return root != "ServerStorage";
  if (script.className == "LocalScript")
    return root.rfind("Starter", 0) == 0 || root == "ReplicatedFirst";
  const bool isModelFile = tree.service("Workspace") == kNoInstance;
  return isModelFile || root == "Workspace" || root == "ServerScriptService" ||
         isInStarterCharacter(tree, id);
}

// True if the text gives something another parent; `Parent = nil` gives none.
bool hasParents(std::string_view text) {
  constexpr std::string_view kBlanks = " \t";
  for (const std::string_view parent : {".Parent", ".parent"})
    for (size_t at = 0; (at = text.find(parent, at)) != std::string_view::npos;) {
      at = std::min(text.find_first_not_of(kBlanks, at + parent.size()), text.size());
      if (text.substr(at, 1) != "=" || text.substr(at, 2) == "==") continue;
      const size_t value = text.find_first_not_of(kBlanks, at + 1);
      if (value != std::string_view::npos && text.substr(value, 3) != "nil") return true;
    }
  return false;
}

// Signals of parts, and of zones as a module of many places makes them; lower case.
constexpr std::string_view kTouches[] = {"touched", "playerentered", "localplayerentered",
                                         "partentered", "itementered"};

// The room that a reading takes. The timeline of the script itself is not counted: there are no
// more of them than scripts in the file.
size_t roomOf(const ScriptReading& reading) {
  size_t room = 0;
  for (const Timeline& timeline : reading.timelines) room += luau::roomOf(timeline);
  return room - 1;
}

// The scripts of a place, within one budget of steps and one of room.
class PlaceReader {
 public:
  PlaceReader(const Tree& tree, size_t room) : tree_(tree), room_(room) {}

  ScriptReading readFirst(InstanceId script, const std::string& source) {
    ScriptReading reading = follow(script, source, nullptr);
    reading.lines = LineIndex(source);
    reading.givesParents = hasParents(source);
    reading.makesJoints = hasAny(source, kJointWords);
    return reading;
  }

  // Adds the readings of those `asleep` that the readings enable, and of what these enable in turn:
  // each once. `byItself`: whatever players do; else by touches and the like, too.
  void readWoken(std::vector<ScriptReading>& readings, std::set<InstanceId>& asleep,
                 bool byItself) {
    for (size_t i = 0; i < readings.size() && !asleep.empty(); ++i)
      for (const Enabling& enabling : enablingsOf(tree_, readings[i], byItself)) {
        if (asleep.erase(enabling.script) == 0) continue;
        const auto* source = property<std::string>(tree_.at(enabling.script), "Source");
        ScriptReading woken = readFirst(enabling.script, *source);
        woken.enabledBy = scriptReason(tree_, readings[i], enabling.line);
        readings.push_back(std::move(woken));
      }
  }

  // After all first readings. Of this one the harm alone counts that a handler may do by then.
  void readAgain(ScriptReading& reading) {
    if (!isReached(reading.script)) return;
    const auto* source = property<std::string>(tree_.at(reading.script), "Source");
    ScriptReading now = follow(reading.script, *source, &changes_);
    const size_t before = roomOf(reading);
    const auto isAgain = [](const Timeline& timeline) { return timeline.again; };
    if (!now.cutAgain) std::erase_if(reading.timelines, isAgain);  // else the first may have more
    reading.cutAgain = reading.cutAgain || now.cutAgain;
    for (Timeline& timeline : now.timelines)
      if (isAgain(timeline)) reading.timelines.push_back(std::move(timeline));
    room_ = room_ + before - roomOf(reading);
  }

 private:
  // `changes`: of all scripts; null: some have not been read.
  ScriptReading follow(InstanceId script, const std::string& source, const luau::Changes* changes) {
    const luau::Chunk chunk = luau::parse(source);
    const size_t share = std::min(kScriptSteps, left_);
    size_t budget = share;
    luau::Reader reader(tree_, script, budget, room_, changes);
    ScriptReading reading = reader.read(chunk);
    left_ -= share - budget;
    if (changes) {
      // Maybe before it came to that.
      reading.cutAgain = reading.cutAgain || budget == 0 || reader.isFull();
      return reading;
    }
    room_ -= roomOf(reading);
    if (!changes_.add(reader.changed(), script, runsOnClient(tree_.at(script))))
      reading.cutChanges = true;
    keepAsked(script, reader.asked());
    return reading;
  }

  // Without room for all that a script asks for it is read anew, whatever others set.
  void keepAsked(InstanceId script, const luau::Keys& keys) {
    if (keys.size() >= luau::kMaxKeys - keptAsked_) {
      asksMuch_.insert(script);
    } else if (!keys.empty()) {
      keptAsked_ += keys.size();
      asked_.emplace(script, keys);
    }
  }

  // Whether a handler of the script has asked for what another script sets, or for too much to
  // tell.
  bool isReached(InstanceId script) const {
    if (asksMuch_.count(script) > 0) return true;
    const auto asked = asked_.find(script);
    if (asked == asked_.end()) return false;
    const bool onClient = runsOnClient(tree_.at(script));
    return std::any_of(asked->second.begin(), asked->second.end(),
                       [&](const luau::Key& key) { return changes_.reach(key, script, onClient); });
  }

  const Tree& tree_;
  size_t left_ = kPlaceSteps;
  size_t room_;  // for more events and timelines
  luau::Changes changes_;
  std::map<InstanceId, luau::Keys> asked_;  // by script
  size_t keptAsked_ = 0;                    // keys in asked_, less than luau::kMaxKeys
  std::set<InstanceId> asksMuch_;           // scripts for which there was no room in it
};

}  // namespace

bool Timeline::ofUnknownTouch() const {
  return trigger == Trigger::other &&
         std::find(std::begin(kTouches), std::end(kTouches), lower(signal)) != std::end(kTouches);
}

bool isInStarterCharacter(const Tree& tree, InstanceId id) {
  for (; id != kNoInstance; id = tree.at(id).parent)
    if (tree.at(id).className == "StarterCharacterScripts") return true;
  return false;
}

std::vector<ScriptReading> readScripts(const Tree& tree, size_t room) {
  PlaceReader reader(tree, room);
  std::vector<ScriptReading> readings;
  std::set<InstanceId> asleep;
  for (InstanceId id = 0; id < tree.size(); ++id) {
    if (!isScriptClass(tree.at(id).className) || !canRun(tree, id)) continue;
    const auto* source = property<std::string>(tree.at(id), "Source");
    if (!source || source->empty() || source->size() > kMaxSource) continue;
    if (isDisabled(tree.at(id)))
      asleep.insert(id);
    else
      readings.push_back(reader.readFirst(id, *source));
  }
  const size_t awake = readings.size();
  reader.readWoken(readings, asleep, true);
  const size_t byItself = readings.size();
  reader.readWoken(readings, asleep, false);
  for (ScriptReading& reading : readings) reader.readAgain(reading);
  for (size_t i = awake; i < readings.size(); ++i) doubtAll(readings[i], i < byItself);
  return readings;
}

std::string scriptReason(const Tree& tree, const ScriptReading& reading, int line) {
  std::string text = "script " + tree.at(reading.script).name + " line " + std::to_string(line);
  const auto code = reading.lines.line(line < 1 ? 0 : size_t(line));
  return code ? text + ": " + quoteOf(*code) : text;
}

}  // namespace obby::importer
