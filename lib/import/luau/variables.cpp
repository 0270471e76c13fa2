// Values that are set are compared with those that are found; things are left as they come.
#include "import/luau/variables.h"

#include <algorithm>

#include "import/luau/values.h"

namespace obby::importer::luau {
namespace {

constexpr size_t kMostGiven = 16;        // values of one variable that are told apart
constexpr size_t kLongestText = 100;     // of those
constexpr size_t kMostInBranch = 10000;  // places: others are left as it sets them
constexpr size_t kMostFound = 64;        // places that a handler has set for those that it makes
constexpr size_t kMostCalled = 32;       // functions that one calls, and these in turn
constexpr size_t kMadePerStep = 8;       // scopes and tables of a branch

// What conditions ask for, and no thing.
bool isPlain(const Datum& value) {
  return value.as<Nil>() || value.as<bool>() || value.as<double>() || value.as<std::string>() ||
         isColor(value);
}

bool isSame(const Datum& a, const Datum& b) { return truthOf(compared("==", a, b)) == Truth::yes; }

bool isUntold(const Datum& value) { return value.as<Unknown>() || value.as<Stranger>(); }

// As far as it is told apart from others.
Datum told(const Datum& value) {
  const auto* text = value.as<std::string>();
  const bool kept = isPlain(value) && !(text && text->size() > kLongestText);
  return kept ? value : Datum{};
}

// Whether a place that held nothing was given a thing: that stays, as what is done with it shows.
bool keepsThing(const std::optional<Datum>& before, const Datum& now) {
  return (!before || before->as<Nil>()) && !isPlain(now);
}

void setBack(Held& held, Held::iterator now, const std::optional<Datum>& before) {
  if (before)
    now->second = *before;
  else
    held.erase(now);
}

// What a place holds behind a branch that may have set it.
Datum eitherOf(const Datum& before, const Datum& now) {
  if (now.as<Nil>() && !isPlain(before)) return before;
  const bool value = isPlain(now) || now.as<Vector>() || now.as<Frame>() || now.as<Ref>();
  return value ? oneOf(before, now) : now;
}

// Where the target of an assignment is, as a function with that scope finds it; null: elsewhere.
Held* holderOf(const Expr& target, Scope* scope) {
  const bool field = target.kind != ExprKind::name;
  const Expr& root = field ? *target.kids[0] : target;
  Scope* holder = scope->holder(root.text);
  if (!holder || !field) return holder ? &holder->names : nullptr;
  const auto* table = holder->names[root.text].as<Table*>();
  return table ? &(*table)->fields : nullptr;
}

Datum statedBy(const Setting& setting) {
  return setting.value ? told(literalOf(*setting.value)) : Datum{};
}

}  // namespace

void Variables::beginHandler(const Function* body, bool eachFrame, const Found& found) {
  body_ = body;
  inHandler_ = true;
  eachFrame_ = eachFrame;
  for (const auto& [place, value] : found) set(*place.first, place.second, value, false);
}

void Variables::beginThread(const Function* body) {
  body_ = body;
  inThread_ = true;
  eachFrame_ = false;
}

void Variables::endHandler() {
  inHandler_ = inThread_ = false;
  for (const auto& [place, old] : before_) {
    Held& held = *place.first;
    const auto now = held.find(place.second);
    if (now != held.end() && !keepsThing(old, now->second)) setBack(held, now, old);
  }
  before_.clear();
}

Variables::Found Variables::heldNow(bool numbers) const {
  Found all;
  if (before_.size() > kMostFound) return all;
  for (const auto& [place, old] : before_) {
    const auto now = place.first->find(place.second);
    if (now == place.first->end()) continue;
    const bool number = now->second.as<double>() != nullptr;
    if (number ? numbers : !isPlain(now->second)) all.emplace_back(place, now->second);
  }
  return all;
}

void Variables::beginLoop() {
  inLoop_ = true;
  looped_.clear();
}

void Variables::endLoop(bool endless) {
  inLoop_ = false;
  for (const auto& [place, turns] : looped_)
    if (endless && turns) add(place, {nullptr, {}, true});
  looped_.clear();
}

size_t Variables::endBranch(bool left, const std::string& defaulted) {
  Branch branch = std::move(branches_.back());
  branches_.pop_back();
  Branch* const outer = branches_.empty() ? nullptr : &branches_.back();
  for (const auto& [place, old] : branch.olds) {
    Held& held = *place.first;
    if (outer && outer->made.count(&held) == 0) outer->olds.try_emplace(place, old);
    const auto now = held.find(place.second);
    if (now == held.end() || keepsThing(old, now->second)) continue;
    const bool isDefault = place.second == defaulted && old && isUntold(*old);
    if (again_)
      doubt(place, old, now->second, isDefault);
    else if (left)
      setBack(held, now, old);
    else if (!isDefault)
      now->second = eitherOf(old ? *old : Datum{Nil{}}, now->second);
    else if (now->second.as<bool>())
      now->second = {};
  }
  const size_t made = branch.made.size();
  if (outer) outer->made.merge(branch.made);
  return branch.olds.size() + made / kMadePerStep;
}

// Behind a branch of a handler that is read once more: of flags, numbers and texts another handler
// may have set one, too. Where the branch sets what was there they are as the handler found them.
// What was not told, as behind an earlier branch, stays so; things are as the first reading has
// them.
void Variables::doubt(const Place& place, const std::optional<Datum>& old, Datum& now,
                      bool isDefault) {
  if (old && isSame(*old, now)) {
    const auto kept = before_.find(place);
    if (kept != before_.end() && kept->second && isSame(*kept->second, now)) before_.erase(kept);
  } else if (isPlain(now) && !isDefault && (!old || isPlain(*old) || isUntold(*old))) {
    now = old && isUntold(*old) ? *old : Datum{};
  }
}

void Variables::set(Held& held, const std::string& name, Datum value, bool own) {
  if (own && !again_) {
    held[name] = std::move(value);
    return;
  }
  const auto found = held.find(name);
  const bool isNew = found == held.end();
  const Place place{&held, name};
  const auto keep = [&](Olds& olds) {
    const auto [kept, isFirst] = olds.try_emplace(place);
    if (isFirst && !isNew) kept->second = found->second;
  };
  if (inHandler_ && !own) {
    keep(before_);
    add(place, {body_, told(value), true});
  }
  Branch* const branch = branches_.empty() ? nullptr : &branches_.back();
  if (branch && branch->olds.size() < kMostInBranch && branch->made.count(&held) == 0)
    keep(branch->olds);
  if (!inHandler_ && inLoop_ && isPlain(value)) {
    bool& turns = looped_[place];
    turns = turns || !isSame(isNew ? Datum{Nil{}} : found->second, value);
  }
  held[name] = std::move(value);
}

Datum Variables::get(Held& held, const std::string& name, bool own) const {
  const auto found = held.find(name);
  Datum value = found == held.end() ? Datum{Nil{}} : found->second;
  const bool open = inHandler_ || (inThread_ && truthOf(value) == Truth::no);
  if (own || !open || given_.empty() || !isPlain(value)) return value;
  const Place place{&held, name};
  const auto given = given_.find(place);
  if (given == given_.end() || before_.count(place) > 0) return value;
  const auto isOwn = [&](const Given& one) { return one.by == body_; };
  const auto& all = given->second;
  if (eachFrame_ && std::any_of(all.begin(), all.end(), isOwn)) return value;
  // One that keeps the others out for a time, as they do, comes when none of them is at it.
  const auto isLock = [&](const Given& one) { return one.passing && isOwn(one); };
  const bool locks = !again_ && std::any_of(all.begin(), all.end(), isLock);
  const bool either = std::any_of(all.begin(), all.end(), [&](const Given& one) {
    const bool setsBack = isOwn(one) && !one.value.as<Unknown>();  // or keeps it from the next time
    const bool counts = again_ || (inHandler_ ? !setsBack : one.followed && !isOwn(one));
    return counts && !(locks && one.passing) && !isSame(one.value, value);
  });
  return either ? Datum{} : value;
}

void Variables::settle(Held& held, const std::string& name) {
  const auto found = held.find(name);
  if (inHandler_ && found != held.end()) before_.try_emplace(Place{&held, name}, found->second);
}

size_t Variables::note(const Closure& closure) {
  Functions seen;
  return note(closure, closure.function, seen);
}

size_t Variables::note(const Closure& closure, const Function* by, Functions& seen) {
  if (!closure.function || !closure.scope || seen.size() >= kMostCalled) return 0;
  if (!seen.insert(closure.function).second) return 0;
  const auto [known, isNew] = settings_.try_emplace(closure.function);
  if (isNew) known->second = settingsOf(*closure.function);
  const Settings& settings = known->second;
  for (const Setting& setting : settings.all) {
    Held* held = holderOf(*setting.target, closure.scope);
    if (held) add({held, *setting.name}, {by, statedBy(setting), false, setting.passing});
  }
  size_t count = settings.all.size() + settings.calls.size();
  for (const std::string& name : settings.calls) {
    Scope* holder = closure.scope->holder(name);
    const auto* called = holder ? holder->names[name].as<Closure>() : nullptr;
    if (called) count += note(*called, by, seen);
  }
  return count;
}

void Variables::add(const Place& place, const Given& given) {
  auto& all = given_[place];
  const auto known = std::find_if(all.begin(), all.end(), [&](const Given& one) {
    const bool untold = one.value.as<Unknown>() && given.value.as<Unknown>();
    return one.by == given.by && (untold || isSame(one.value, given.value));
  });
  if (known != all.end()) {
    known->passing = known->passing && (given.passing || given.followed);
    known->followed = known->followed || given.followed;
  } else if (all.size() < kMostGiven) {
    all.push_back(given);
  } else {
    all.back() = {nullptr, {}, true};
  }
}

}  // namespace obby::importer::luau
