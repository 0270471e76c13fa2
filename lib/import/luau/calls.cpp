// Calls of the script reader: waits, spawned functions, signals, methods.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include "import/frame_time.h"
#include "import/luau/reader.h"
#include "import/script_side.h"

namespace obby::importer::luau {
namespace {

constexpr double kOldWait = 1.0 / 30;  // wait() never resumes sooner
constexpr double kLongestWait = 1e6;   // seconds
constexpr size_t kItemsPerStep = 4;    // of a list that is looked through, or moved in it
// Of the name of a signal, or kTagged and a tag of 100 characters: no longer one ever comes.
constexpr size_t kLongestSignal = 150;

bool isFrameSignal(const std::string& name) {
  static constexpr std::string_view kNames[] = {"Heartbeat",     "RenderStepped",  "Stepped",
                                                "PreSimulation", "PostSimulation", "PreRender",
                                                "PreAnimation"};
  return std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames);
}

// Signals that come as play starts: waiting for them puts nothing off.
bool comesAtStart(const std::string& name) {
  static constexpr std::string_view kNames[] = {"PlayerAdded", "CharacterAdded", "Loaded",
                                                "CharacterAppearanceLoaded"};
  return std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames);
}

bool isUnknown(const Datum& datum) { return truthOf(datum) == Truth::unknown; }

bool hasDot(const std::string& path) { return path.find('.') != std::string::npos; }

// The place of a value in a list, nil where it is not; unknown where the text does not tell.
Datum placeOf(const std::vector<Datum>& items, const Datum& value) {
  if (isUnknown(value)) return {};  // the list may have it by then
  for (size_t i = 0; i < items.size(); ++i) {
    const Truth same = truthOf(compared("==", items[i], value));
    if (same != Truth::no) return same == Truth::yes ? Datum{double(i + 1)} : Datum{};
  }
  return {Nil{}};
}

// The signal of parts that get a tag as the game runs; the tag stands behind it.
constexpr std::string_view kTagged = "GetInstanceAddedSignal ";

// Whether a handler is of parts that get a tag later, while the script does the same to those that
// have it by themselves.
bool isOfLater(const Timeline& timeline, const std::vector<std::string>& tagsAsked) {
  if (timeline.signal.rfind(kTagged, 0) != 0) return false;
  const std::string tag = timeline.signal.substr(kTagged.size());
  return std::find(tagsAsked.begin(), tagsAsked.end(), tag) != tagsAsked.end();
}

// table.insert(list, value) adds it at the end, table.insert(list, place, value) before what stands
// there. A place that the text does not tell is the end.
void insertInto(std::vector<Datum>& items, const std::vector<Datum>& arguments) {
  const auto* place = arguments.size() > 2 ? arguments[1].as<double>() : nullptr;
  const bool inside = place && *place >= 1 && *place <= double(items.size());
  const auto at = inside ? items.begin() + (std::ptrdiff_t(*place) - 1) : items.end();
  items.insert(at, arguments.back());
}

}  // namespace

bool isSignalName(const std::string& name) {
  static constexpr std::string_view kNames[] = {
      "Touched",    "touched",        "TouchEnded",      "MouseClick",        "Triggered",
      "Changed",    "Destroying",     "AncestryChanged", "PlayerRemoving",    "PlayerAdded",
      "ChildAdded", "CharacterAdded", "ChildRemoved",    "CharacterRemoving", "Died"};
  return isFrameSignal(name) ||
         std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames);
}

bool isConnect(const std::string& method) {
  return method == "Connect" || method == "connect" || method == "Once" ||
         method == "ConnectParallel";
}

void Reader::waitFor(double seconds, double least) {
  if (std::isnan(seconds) || seconds < least) seconds = least;
  // Threads resume at the first frame at or after the time.
  time_ += std::ceil(std::min(seconds, kLongestWait) / kFrame - 1e-6) * kFrame;
}

// Calls that move the clock or begin something beside what follows.
std::optional<Datum> Reader::scheduled(const std::string& name,
                                       const std::vector<Datum>& arguments) {
  const Datum& first = argument(arguments, 0);
  const auto* number = first.as<double>();
  if (name == "wait" || name == "task.wait" || name == "Wait") {
    const double before = time_;
    vague_ = vague_ || (!arguments.empty() && isUnknown(first));
    waitFor(number ? *number : 0, name == "task.wait" ? kFrame : kOldWait);
    return Datum{time_ - before};
  }
  if (name == "tick" || name == "time" || name == "os.clock" || name == "os.time" ||
      name == "elapsedTime")
    return Datum{time_};
  if (name == "spawn" || name == "Spawn" || name == "task.spawn" || name == "task.defer" ||
      name == "coroutine.wrap" || name == "coroutine.create") {
    beside(first, {arguments.begin() + (arguments.empty() ? 0 : 1), arguments.end()}, 0);
    return Datum{};
  }
  if (name == "delay" || name == "Delay" || name == "task.delay") {
    const bool before = vague_;
    vague_ = vague_ || isUnknown(first);
    const size_t own = std::min<size_t>(2, arguments.size());  // those of the function follow
    beside(argument(arguments, 1), {arguments.begin() + std::ptrdiff_t(own), arguments.end()},
           number && *number > 0 ? std::min(*number, kLongestWait) : 0);
    if (timeline_.trigger == Trigger::start) vague_ = before;  // it has a timeline of its own
    return Datum{};
  }
  if (name == "pcall" || name == "xpcall") {
    const size_t own = std::min<size_t>(name == "pcall" ? 1 : 2, arguments.size());
    if (const auto* closure = first.as<Closure>())
      call(*closure, {arguments.begin() + std::ptrdiff_t(own), arguments.end()});
    return Datum{};
  }
  return std::nullopt;
}

Datum Reader::callValue(const Expr& expr) {
  const Datum callee = evaluate(*expr.kids[0]);
  const auto arguments = evaluateAll(expr.kids, 1);
  if (const auto* closure = callee.as<Closure>()) return call(*closure, arguments);
  const auto* library = callee.as<Library>();
  if (!library) return callee.as<Stranger>() ? callee : Datum{};
  const std::string& name = library->name;
  if (auto result = scheduled(name, arguments)) return *result;
  const Datum& first = argument(arguments, 0);
  if (name == "pairs" || name == "ipairs" || name == "next" || name == "table.clone") return first;
  if (name == "Instance.new") return newInstance(arguments, expr.line);
  if (name == "table.insert" && arguments.size() >= 2) {
    const auto* table = first.as<Table*>();
    const size_t moved = table && arguments.size() > 2 ? (*table)->items.size() : 0;
    if (table && spend(moved / kItemsPerStep)) insertInto((*table)->items, arguments);
    return {};
  }
  if (name == "table.find" && arguments.size() >= 2 && first.as<Table*>()) {
    const Table& list = **first.as<Table*>();
    if (inHandler_ && list.items.empty() && !isOwn(list.born)) return {};  // by then it may be full
    return spend(list.items.size() / kItemsPerStep) ? placeOf(list.items, arguments[1]) : Datum{};
  }
  if (name == "require") {
    reading_.requiresAsset = reading_.requiresAsset || first.as<double>();
    return {};
  }
  if (name == "loadstring" || name == "getfenv" || name == "setfenv") reading_.dynamicCode = true;
  return libraryCall(name, arguments);
}

// The signal that an expression states by a field, or that a variable or a list holds. Without a
// name where the text does not tell.
Signal Reader::signalOf(const Expr& expr) {
  const bool stated = expr.kind == ExprKind::field;
  if (!stated && expr.kind != ExprKind::name && expr.kind != ExprKind::index) return {};
  const Datum from = evaluate(stated ? *expr.kids[0] : expr);
  if (stated && !from.as<Table*>()) {
    const auto* ref = from.as<Ref>();
    const auto* tween = from.as<Tween*>();
    return {ref ? ref->target : kNoInstance, tween ? *tween : nullptr, expr.text};
  }
  const Datum held = stated ? field(from, expr.text) : from;
  if (const auto* signal = held.as<Signal>()) return *signal;
  std::string name = stated ? expr.text : std::string();
  if (const auto* library = held.as<Library>(); library && hasDot(library->name))
    name = library->name.substr(library->name.rfind('.') + 1);
  if (const auto* stranger = held.as<Stranger>()) name = stranger->name;
  return {kNoInstance, nullptr, std::move(name)};
}

Datum Reader::connect(const Expr& expr, const std::vector<Datum>& arguments, bool once) {
  const Datum& function = argument(arguments, 0);
  const Signal signal = signalOf(expr);
  const std::string& name = signal.name;
  Pending pending;
  pending.once = once;
  pending.trigger = Trigger::other;
  pending.signal = name.empty() ? expr.text : name;
  pending.line = expr.line;
  if (name.empty() && expr.text + " " == kTagged && expr.kids.size() > 1) {
    const Datum tag = evaluate(*expr.kids[1]);
    if (const auto* text = tag.as<std::string>()) pending.signal = std::string(kTagged) + *text;
  }
  if (pending.signal.size() > kLongestSignal) pending.signal.resize(kLongestSignal);
  if (isFrameSignal(name)) {
    pending.trigger = Trigger::frame;
    const Datum step{kFrame};
    return connected(
        std::move(pending), function,
        name == "Stepped" ? std::vector<Datum>{{0.0}, step} : std::vector<Datum>{step});
  }
  if (signal.tween && name == "Completed") {
    if (const auto* closure = function.as<Closure>()) signal.tween->completed.push_back(*closure);
    return {};
  }
  const bool ofPart = signal.instance != kNoInstance && tree_.isPart(signal.instance);
  if (ofPart && (name == "Touched" || name == "touched")) {
    pending.trigger = Trigger::touch;
    pending.touched = signal.instance;
  }
  const bool touch = pending.trigger == Trigger::touch;
  if (!touch && lower(name) == "touched" && isOfLater(timeline_, tags_))
    pending.signal = "Touched of a part that comes later";
  if (touch && !function.as<Closure>()) {  // it does something, but what?
    if (!room_.take()) return {};
    Timeline unknown;
    unknown.trigger = pending.trigger;
    unknown.touched = pending.touched;
    unknown.signal = pending.signal;
    unknown.line = pending.line;
    reading_.timelines.push_back(std::move(unknown));
    return {};
  }
  return connected(std::move(pending), function, {{Stranger{touch ? "hit" : "player"}}});
}

// Gives what the signal does: of a tween how it ended.
Datum Reader::waitForSignal(const Expr& expr) {
  const Signal signal = signalOf(expr);
  if (signal.tween) {
    waitFor(secondsLeft(signal.tween), 0);
    return {Library{"Enum.PlaybackState.Completed"}};
  }
  const std::string& name = signal.name.empty() ? expr.text : signal.name;
  vague_ = vague_ || !(isFrameSignal(name) || comesAtStart(name));
  waitFor(0, kFrame);
  return {kFrame};
}

Datum Reader::methodValue(const Expr& expr) {
  const std::string& name = expr.text;
  if (isConnect(name)) return connect(*expr.kids[0], evaluateAll(expr.kids, 1), name == "Once");
  if (name == "Wait" || name == "wait") return waitForSignal(*expr.kids[0]);
  const Datum object = evaluate(*expr.kids[0]);
  const auto arguments = evaluateAll(expr.kids, 1);
  if (name == "GetService" || name == "FindService" || name == "service") {
    const auto* service = argument(arguments, 0).as<std::string>();
    return service ? serviceNamed(*service) : Datum{};
  }
  if (name == "BindToRenderStep") {
    Pending pending;
    pending.trigger = Trigger::frame;
    later(std::move(pending), argument(arguments, 2), {{kFrame}});
    return {};
  }
  if (name == "GetServerTimeNow") return {time_};
  if (name == "Create" && arguments.size() >= 3) return createTween(arguments, expr.line);
  return methodOf(object, name, arguments, expr.line);
}

Datum Reader::methodOf(const Datum& object, const std::string& name,
                       const std::vector<Datum>& arguments, int line) {
  if (name == "IsStudio" && !object.as<Table*>()) return {false};  // players are not there
  if ((name == "IsServer" || name == "IsClient") && !object.as<Table*>())
    return {runsOnClient(tree_.at(reading_.script)) == (name == "IsClient")};
  if (name == "HasTag" && arguments.size() > 1)  // CollectionService:HasTag(part, "Lava")
    return methodOf(arguments[0], name, {arguments[1]}, line);
  if (const auto* tween = object.as<Tween*>()) {
    if (name == "Play") play(*tween, line);
    if (name == "Cancel" || name == "Pause") stop(*tween, name == "Pause");
    return {};
  }
  if (const auto* connection = object.as<Connection>()) {
    if (name == "Disconnect" || name == "disconnect") disconnect(*connection, line);
    return {};
  }
  if (const auto* ref = object.as<Ref>()) return instanceMethod(ref->target, name, arguments, line);
  if (const auto* library = object.as<Library>()) {
    if (library->name == "Debris") return destroyLater(name, arguments, line);
    if (name == "GetTagged" || library->name == "workspace" || library->name == "game")
      return instanceMethod(kNoInstance, name, arguments, line);
    return {};
  }
  if (const auto* table = object.as<Table*>()) {
    const auto it = (*table)->fields.find(name);
    const auto* closure = it == (*table)->fields.end() ? nullptr : it->second.as<Closure>();
    if (!closure) return {};
    std::vector<Datum> withSelf = {object};
    withSelf.insert(withSelf.end(), arguments.begin(), arguments.end());
    return call(*closure, withSelf);
  }
  if (const auto* stranger = object.as<Stranger>())
    return strangerMethod(stranger->name, name, arguments, line);
  if (object.as<Unknown>()) return strangerMethod("", name, arguments, line);
  return valueMethod(object, name, arguments);
}

}  // namespace obby::importer::luau
