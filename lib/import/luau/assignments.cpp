// Walks over the parsed script, functions and all.
#include "import/luau/assignments.h"

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "import/luau/values.h"
#include "import/tree.h"

namespace obby::importer::luau {
namespace {

constexpr unsigned kNil = 1, kTruth = 2, kFalsehood = 4, kOther = 8;
constexpr size_t kLongestName = 100;

unsigned kindOf(const Expr& value) {
  if (value.kind == ExprKind::nil) return kNil;
  if (value.kind == ExprKind::truth) return kTruth;
  return value.kind == ExprKind::falsehood ? kFalsehood : kOther;
}

// The text of an expression that is one; null: it is another, or has no use as a name.
const std::string* textOf(const Expr& expr) {
  const bool text = expr.kind == ExprKind::string && expr.known;
  return text && expr.text.size() <= kLongestName ? &expr.text : nullptr;
}

// The text that a method is called with: `script:WaitForChild("Busy")`.
const std::string* textOfCall(const Expr& call) {
  return call.kids.size() > 1 ? textOf(*call.kids[1]) : nullptr;
}

bool isMethod(const Expr& expr, const char* name) {
  return expr.kind == ExprKind::method && expr.text == name;
}

// The last name on the way to a value object; empty: it has none.
std::string objectName(const Expr& expr) {
  const bool child = isMethod(expr, "WaitForChild") || isMethod(expr, "FindFirstChild");
  const std::string* asked = child ? textOfCall(expr) : nullptr;
  if (expr.kind == ExprKind::name || expr.kind == ExprKind::field) asked = &expr.text;
  return asked ? lower(*asked) : std::string();
}

// Whether a call connects a handler that comes at a time of its own, and not at the end of a tween.
bool connectsOther(const Expr& call) {
  if (call.kind != ExprKind::method || !isConnect(call.text)) return false;
  const Expr& signal = *call.kids[0];
  return signal.kind != ExprKind::field || signal.text != "Completed";
}

// The assignments of a function, but for those to its own names.
class SettingsWalk {
 public:
  void walk(const Function& function) {
    own_.insert(function.parameters.begin(), function.parameters.end());
    walk(function.body);
  }
  Settings found() {
    markPassing();
    std::erase_if(found_.calls, [&](const std::string& name) { return own_.count(name) > 0; });
    std::erase_if(found_.all,
                  [&](const Setting& setting) { return own_.count(rootOf(setting)) > 0; });
    return std::move(found_);
  }

 private:
  void walk(const Block& block) {
    for (const StatPtr& stat : block) {
      own_.insert(stat->names.begin(), stat->names.end());
      take(*stat);
      if (stat->kind == StatKind::returns || stat->kind == StatKind::leaves) ++waysOut_;
      for (const ExprPtr& target : stat->targets) walk(*target);
      for (const ExprPtr& value : stat->values) walk(*value);
      for (const Block& inner : stat->blocks) walkApart(inner);
    }
  }
  void walk(const Expr& expr) {
    const bool connects = connectsOther(expr);
    const bool calls = expr.kind == ExprKind::call || (expr.kind == ExprKind::method && !connects);
    for (const ExprPtr& kid : expr.kids) {
      const bool function = kid->kind == ExprKind::function;
      if (calls && function)
        walk(*kid->body);  // it is called from here: now, or a while later
      else if (!function || !connects)
        walk(*kid);
      if (calls && kid->kind == ExprKind::name) found_.calls.insert(kid->text);
    }
    for (const ExprPtr& key : expr.keys)
      if (key) walk(*key);
    if (expr.body) walkApart(*expr.body);
  }
  // What may come or not, whatever stands around it.
  template <class Inner>
  void walkApart(const Inner& inner) {
    const size_t outer = std::exchange(block_, ++blocks_);
    walk(inner);
    block_ = outer;
  }
  void take(const Stat& stat) {
    const bool plain = stat.kind == StatKind::assign;
    if (!plain && stat.kind != StatKind::compound) return;
    for (size_t i = 0; i < stat.targets.size(); ++i) {
      const Expr& target = *stat.targets[i];
      const bool keyed = target.kind == ExprKind::index;
      const bool leads = keyed || target.kind == ExprKind::field;
      const bool taken =
          leads ? target.kids[0]->kind == ExprKind::name : target.kind == ExprKind::name;
      const std::string* name = keyed ? textOf(*target.kids[1]) : &target.text;
      if (!taken || !name) continue;
      const Expr* value = plain && i < stat.values.size() ? stat.values[i].get() : nullptr;
      found_.all.push_back({&target, name, value});
      places_.push_back({block_, waysOut_});
    }
  }
  static const std::string& rootOf(const Setting& setting) {
    const Expr& target = *setting.target;
    return target.kind == ExprKind::name ? target.text : target.kids[0]->text;
  }
  static bool isFlag(const Setting& setting) {
    return setting.value && kindOf(*setting.value) != kOther;
  }
  void markPassing() {
    std::map<std::pair<std::string, std::string>, std::vector<size_t>> byName;
    for (size_t i = 0; i < found_.all.size(); ++i) {
      const Setting& setting = found_.all[i];
      const bool field = setting.target->kind != ExprKind::name;
      byName[{rootOf(setting), field ? *setting.name : std::string()}].push_back(i);
    }
    for (const auto& entry : byName) {
      const std::vector<size_t>& at = entry.second;
      if (at.size() != 2 || places_[at[0]] != places_[at[1]]) continue;
      Setting& first = found_.all[at[0]];
      first.passing = isFlag(first) && isFlag(found_.all[at[1]]);
    }
  }

  // Of each setting its block, and how many ways out stand before it.
  std::vector<std::pair<size_t, size_t>> places_;
  size_t block_ = 0, blocks_ = 0, waysOut_ = 0;
  std::set<std::string> own_;
  Settings found_;
};

}  // namespace

Datum literalOf(const Expr& expr) {
  switch (expr.kind) {
    case ExprKind::nil: return {Nil{}};
    case ExprKind::truth: return {true};
    case ExprKind::falsehood: return {false};
    case ExprKind::number: return {expr.number};
    case ExprKind::string: return expr.known ? Datum{expr.text} : Datum{};
    default: return {};
  }
}

std::string flagName(const Expr& expr) {
  if (expr.text.size() > kLongestName) return {};
  if (expr.kind == ExprKind::name) return expr.text;
  if (isMethod(expr, "GetAttribute") || isMethod(expr, "SetAttribute")) {
    const std::string* name = textOfCall(expr);
    return name ? "@" + *name : std::string();
  }
  if (expr.kind == ExprKind::index) {
    const std::string* name = textOf(*expr.kids[1]);
    return name ? "." + *name : std::string();
  }
  if (expr.kind != ExprKind::field) return {};
  if (expr.text != "Value") return "." + expr.text;
  const std::string object = objectName(*expr.kids[0]);
  return object.empty() ? object : "=" + object;
}

Settings settingsOf(const Function& function) {
  SettingsWalk walk;
  walk.walk(function);
  return walk.found();
}

bool Assignments::isFlag(const std::string& name) const {
  const auto given = given_.find(name);
  if (given == given_.end()) return false;
  return given->second == kNil || given->second == kTruth || given->second == kFalsehood;
}

bool Assignments::isSet(const std::string& name, const Datum& value) const {
  const auto given = given_.find(name);
  if (given == given_.end()) return false;
  if (value.as<Nil>()) return given->second == kNil;
  const auto* flag = value.as<bool>();
  return flag && given->second == (*flag ? kTruth : kFalsehood);
}

void Assignments::walk(const Block& block, bool outermost) {
  for (const StatPtr& stat : block) {
    if (!outermost) take(*stat);
    for (const ExprPtr& target : stat->targets) walk(*target);
    for (const ExprPtr& value : stat->values) walk(*value);
    for (const Block& inner : stat->blocks) walk(inner, outermost && stat->kind == StatKind::block);
  }
}

void Assignments::walk(const Expr& expr) {
  for (const ExprPtr& kid : expr.kids) walk(*kid);
  for (const ExprPtr& key : expr.keys)
    if (key) walk(*key);
  if (expr.body) walk(expr.body->body, false);
}

void Assignments::take(const Stat& stat) {
  const bool plain = stat.kind == StatKind::assign;
  for (size_t i = 0; i < stat.targets.size(); ++i) {
    const std::string name = flagName(*stat.targets[i]);
    if (name.empty()) continue;
    const Expr* value = plain && i < stat.values.size() ? stat.values[i].get() : nullptr;
    given_[name] |= value ? kindOf(*value) : kOther;
    if (value && value->kind == ExprKind::table) takeFields(*value);
  }
  if (stat.kind == StatKind::call) takeCall(*stat.values[0]);
}

// `part:SetAttribute("Busy", true)`; without a value it is taken away.
void Assignments::takeCall(const Expr& call) {
  const std::string name = isMethod(call, "SetAttribute") ? flagName(call) : std::string();
  if (!name.empty()) given_[name] |= call.kids.size() > 2 ? kindOf(*call.kids[2]) : kNil;
}

// A table that takes the place of another: `state = {busy = false}`.
void Assignments::takeFields(const Expr& table) {
  for (size_t i = 0; i < table.kids.size() && i < table.keys.size(); ++i) {
    const std::string* name = table.keys[i] ? textOf(*table.keys[i]) : nullptr;
    if (name) given_["." + *name] |= kindOf(*table.kids[i]);
  }
}

}  // namespace obby::importer::luau
