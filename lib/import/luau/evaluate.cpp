// Expressions of the script reader.
#include <algorithm>
#include <cmath>

#include "import/luau/reader.h"

namespace obby::importer::luau {
namespace {

constexpr double kFrame = 1.0 / 60;
constexpr double kOldWait = 1.0 / 30;  // wait() never resumes sooner

const Datum& argument(const std::vector<Datum>& arguments, size_t i) {
  static const Datum kNone;
  return i < arguments.size() ? arguments[i] : kNone;
}

bool isFrameSignal(const std::string& name) {
  static constexpr std::string_view kNames[] = {"Heartbeat",     "RenderStepped",  "Stepped",
                                                "PreSimulation", "PostSimulation", "PreRender",
                                                "PreAnimation"};
  return std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames);
}

}  // namespace

std::vector<Datum> Reader::evaluateAll(const std::vector<ExprPtr>& list, size_t from) {
  std::vector<Datum> values;
  for (size_t i = from; i < list.size(); ++i) values.push_back(evaluate(*list[i]));
  return values;
}

Datum Reader::evaluate(const Expr& expr) {
  if (!spend()) return {};
  switch (expr.kind) {
    case ExprKind::nil: return {Nil{}};
    case ExprKind::truth: return {true};
    case ExprKind::falsehood: return {false};
    case ExprKind::number: return {expr.number};
    case ExprKind::string: return {expr.text};
    case ExprKind::name: return nameValue(expr.text);
    case ExprKind::field: return field(evaluate(*expr.kids[0]), expr.text);
    case ExprKind::index: {
      const Datum object = evaluate(*expr.kids[0]);
      return indexed(object, evaluate(*expr.kids[1]));
    }
    case ExprKind::call: return callValue(expr);
    case ExprKind::method: return methodValue(expr);
    case ExprKind::function: return {Closure{expr.body.get(), scope_}};
    case ExprKind::table: return tableValue(expr);
    case ExprKind::binary: return binary(expr);
    case ExprKind::choice: {
      const Truth truth = truthOf(evaluate(*expr.kids[0]));
      return evaluate(*expr.kids[truth == Truth::no ? 2 : 1]);
    }
    case ExprKind::unary: {
      const Datum value = evaluate(*expr.kids[0]);
      if (expr.text == "not") return datumOf(negated(truthOf(value)));
      if (expr.text == "-") return arithmetic("*", value, {-1.0});
      if (const auto* table = value.as<std::shared_ptr<Table>>())
        return {double((*table)->items.size())};
      return {};
    }
    case ExprKind::vararg:
    case ExprKind::unknown: return {};
  }
  return {};
}

Datum Reader::nameValue(const std::string& name) {
  if (Scope* holder = scope_->holder(name)) return holder->names[name];
  if (name == "workspace" || name == "Workspace") return serviceNamed("Workspace");
  if (name == "game" || name == "Game") return {Library{"game"}};
  return {Library{name}};
}

Datum Reader::binary(const Expr& expr) {
  const Datum left = evaluate(*expr.kids[0]);
  if (expr.text == "and" || expr.text == "or") {
    const Truth truth = truthOf(left);
    const bool decided = truth == (expr.text == "and" ? Truth::no : Truth::yes);
    if (decided) return left;
    const Datum right = evaluate(*expr.kids[1]);
    if (truth != Truth::unknown) return right;
    // `x and 5`: unknown as a condition, but worth its value to an assignment.
    return expr.text == "or" && !right.as<bool>() ? right : Datum{};
  }
  const Datum right = evaluate(*expr.kids[1]);
  const char first = expr.text[0];
  if (first == '<' || first == '>' || first == '=' || first == '~')
    return compared(expr.text, left, right);
  return arithmetic(expr.text, left, right);
}

Datum Reader::tableValue(const Expr& expr) {
  auto table = std::make_shared<Table>();
  for (size_t i = 0; i < expr.kids.size(); ++i) {
    Datum value = evaluate(*expr.kids[i]);
    if (!expr.keys[i]) {
      // {folder:GetChildren()} spreads nothing here: a list stays one item.
      table->items.push_back(std::move(value));
      continue;
    }
    const Datum key = evaluate(*expr.keys[i]);
    if (const auto* name = key.as<std::string>()) table->fields[*name] = std::move(value);
  }
  return {table};
}

Datum Reader::field(const Datum& object, const std::string& name) {
  if (const auto* ref = object.as<Ref>()) return instanceField(ref->target, name);
  if (const auto* library = object.as<Library>()) {
    if (library->name == "game" || library->name == "workspace") return serviceNamed(name);
    return libraryField(library->name + "." + name);
  }
  if (const auto* table = object.as<std::shared_ptr<Table>>()) {
    const auto it = (*table)->fields.find(name);
    return it == (*table)->fields.end() ? Datum{Nil{}} : it->second;
  }
  if (const auto* made = object.as<std::shared_ptr<Made>>()) return madeField(*made, name);
  if (object.as<Vector>() || object.as<Frame>()) return valueMethod(object, name, {});
  if (object.as<Stranger>() || object.as<Unknown>()) return {Stranger{name}};
  return {};
}

Datum Reader::indexed(const Datum& object, const Datum& key) {
  if (const auto* name = key.as<std::string>()) return field(object, *name);
  const auto* table = object.as<std::shared_ptr<Table>>();
  if (!table) return object.as<Stranger>() ? object : Datum{};
  const auto& items = (*table)->items;
  if (const auto* n = key.as<double>()) {
    const bool inside = *n >= 1 && *n <= double(items.size());
    return inside ? items[size_t(*n) - 1] : Datum{Nil{}};
  }
  return items.size() == 1 ? items[0] : Datum{};
}

void Reader::waitFor(double seconds, double least) {
  if (std::isnan(seconds) || seconds < least) seconds = least;
  // Threads resume at the first frame at or after the time.
  time_ += std::ceil(std::min(seconds, 1e6) / kFrame - 1e-6) * kFrame;
}

Datum Reader::callValue(const Expr& expr) {
  const Datum callee = evaluate(*expr.kids[0]);
  const auto arguments = evaluateAll(expr.kids, 1);
  if (const auto* closure = callee.as<Closure>()) return call(*closure, arguments);
  const auto* library = callee.as<Library>();
  if (!library) return callee.as<Stranger>() ? callee : Datum{};
  const std::string& name = library->name;
  const Datum& first = argument(arguments, 0);
  const auto* number = first.as<double>();
  if (name == "wait" || name == "task.wait" || name == "Wait") {
    const double before = time_;
    waitFor(number ? *number : 0, name == "task.wait" ? kFrame : kOldWait);
    return {time_ - before};
  }
  if (name == "tick" || name == "time" || name == "os.clock" || name == "os.time" ||
      name == "elapsedTime" || name == "workspace.GetServerTimeNow")
    return {time_};
  if (name == "spawn" || name == "Spawn" || name == "task.spawn" || name == "task.defer" ||
      name == "coroutine.wrap" || name == "coroutine.create") {
    beside(first, {arguments.begin() + (arguments.empty() ? 0 : 1), arguments.end()}, 0);
    return {};
  }
  if (name == "delay" || name == "Delay" || name == "task.delay") {
    beside(argument(arguments, 1), {}, number ? *number : 0);
    return {};
  }
  if (name == "pcall" || name == "xpcall") {
    if (const auto* closure = first.as<Closure>()) call(*closure, {});
    return {};
  }
  if (name == "pairs" || name == "ipairs" || name == "next" || name == "table.clone") return first;
  if (name == "require") {
    reading_.requiresAsset = reading_.requiresAsset || number != nullptr;
    return {};
  }
  if (name == "loadstring" || name == "getfenv" || name == "setfenv") reading_.dynamicCode = true;
  return libraryCall(name, arguments);
}

void Reader::connect(const Expr& signal, const std::vector<Datum>& arguments) {
  const Datum& function = argument(arguments, 0);
  Pending pending;
  pending.trigger = Trigger::other;
  pending.signal = signal.text;
  pending.line = signal.line;
  const Datum source = signal.kind == ExprKind::field ? evaluate(*signal.kids[0]) : Datum{};
  const std::string& name = signal.text;
  const auto* ref = source.as<Ref>();
  const auto* tween = source.as<std::shared_ptr<Tween>>();
  if (signal.kind == ExprKind::field && isFrameSignal(name)) {
    pending.trigger = Trigger::frame;
    const Datum step{kFrame};
    later(std::move(pending), function,
          name == "Stepped" ? std::vector<Datum>{{0.0}, step} : std::vector<Datum>{step});
  } else if (tween && name == "Completed") {
    if (const auto* closure = function.as<Closure>()) (*tween)->completed.push_back(*closure);
  } else {
    if (ref && (name == "Touched" || name == "touched") && tree_.isPart(ref->target)) {
      pending.trigger = Trigger::touch;
      pending.touched = ref->target;
    }
    const bool touch = pending.trigger == Trigger::touch;
    later(std::move(pending), function, {{Stranger{touch ? "hit" : "player"}}});
  }
}

void Reader::play(const std::shared_ptr<Tween>& tween, int line) {
  for (const Played& before : played_) {
    if (before.tween != tween || timeline_.forever) continue;
    timeline_.forever = true;  // it comes round again
    timeline_.loopStart = before.time;
    timeline_.loopEvent = before.event;
    timeline_.period = time_ - before.time;
    return;
  }
  played_.push_back({tween, time_, timeline_.events.size()});
  for (const auto& [name, value] : tween->goals) {
    if (tween->target == kNoInstance) continue;
    const size_t first = timeline_.events.size();
    setInstance(tween->target, name, value, line);
    for (size_t i = first; i < timeline_.events.size(); ++i) {
      timeline_.events[i].kind = EventKind::tween;
      timeline_.events[i].tween = tween->timing;
    }
  }
}

Datum Reader::methodValue(const Expr& expr) {
  const std::string& name = expr.text;
  if (name == "Connect" || name == "connect" || name == "Once" || name == "ConnectParallel" ||
      name == "connectFirst") {
    connect(*expr.kids[0], evaluateAll(expr.kids, 1));
    return {};
  }
  if (name == "Wait" || name == "wait") {
    const Expr& signal = *expr.kids[0];
    const Datum source = signal.kind == ExprKind::field ? evaluate(*signal.kids[0]) : Datum{};
    if (const auto* tween = source.as<std::shared_ptr<Tween>>()) {
      const TweenTiming& t = (*tween)->timing;
      const double once = t.seconds * (t.reverses ? 2 : 1) * (std::max(t.repeats, 0) + 1);
      waitFor(once + t.delay, 0);
    } else {
      waitFor(0, kFrame);
    }
    return {kFrame};
  }
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
  if (name == "Create" && arguments.size() >= 3) return createTween(arguments, expr.line);
  if (const auto* tween = object.as<std::shared_ptr<Tween>>()) {
    if (name == "Play") play(*tween, expr.line);
    return {};
  }
  if (const auto* ref = object.as<Ref>())
    return instanceMethod(ref->target, name, arguments, expr.line);
  if (const auto* library = object.as<Library>()) {
    if (name == "GetTagged" || library->name == "workspace" || library->name == "game")
      return instanceMethod(kNoInstance, name, arguments, expr.line);
    return {};
  }
  if (const auto* table = object.as<std::shared_ptr<Table>>()) {
    const auto it = (*table)->fields.find(name);
    const auto* closure = it == (*table)->fields.end() ? nullptr : it->second.as<Closure>();
    if (!closure) return {};
    std::vector<Datum> withSelf = {object};
    withSelf.insert(withSelf.end(), arguments.begin(), arguments.end());
    return call(*closure, withSelf);
  }
  if (object.as<Stranger>() || object.as<Unknown>()) {
    const auto* stranger = object.as<Stranger>();
    return strangerMethod(stranger ? stranger->name : "", name, arguments, expr.line);
  }
  return valueMethod(object, name, arguments);
}

}  // namespace obby::importer::luau
