#include "level/clocks.h"

#include <fmt/format.h>

#include "base/hash.h"
#include "level/record_values.h"

namespace obby::level {
namespace {

// Marks the number of a shared clock until the number of roles is known.
constexpr uint32_t kShared = 0x80000000u;

void resolve(uint32_t& clock, uint32_t role, size_t roleCount) {
  if (clock == kNone) return;
  clock = clock == kOwnClock ? role : uint32_t(roleCount) + (clock & ~kShared);
}

}  // namespace

uint64_t digestOf(const Clock& c, uint64_t seed) {
  uint64_t h = seed;
  const auto add = [&h](const auto& value) { h = hashBytes(&value, sizeof value, h); };
  add(c.length), add(c.restarts), add(c.walkFactor), add(c.jumpFactor), add(c.jumpMore);
  add(c.helpless), add(c.seat);
  if (changesGravity(c)) add(c.gravityFactor), add(c.resets);
  return h;
}

Result<uint32_t> ticksOf(const Params& params, float seconds, const std::string& path) {
  if (!(seconds >= 0))
    return pathError(path, "expected 0 or more seconds, found " + shown(seconds));
  return ticksFromSeconds(params, seconds);
}

Status ClockTables::addButton(schema::Part::Reader part, size_t index, const Params& params) {
  const auto button = part.getButton();
  const std::string path = fmt::format("parts[{}].button", index), name = button.getSignal();
  if (name.empty()) {
    return pathError(path + ".signal", "expected the name of a signal, found none",
                     "choose any name, and use it as 'signal' in the parts that respond");
  }
  OBBY_ASSIGN(const uint32_t ticks, ticksOf(params, button.getSeconds(), path + ".seconds"));
  const Clock clock{button.getForever() ? kForever : ticks, button.getRestarts()};
  if (clock.length == 0) {
    return pathError(path + ".seconds", "the signal lasts less than one tick",
                     "raise 'seconds', or set \"forever\":true");
  }
  const auto [it, added] = signals_.try_emplace(name, Signal{uint32_t(shared_.size()), index});
  if (added) {
    shared_.push_back(clock);
  } else if (digestOf(shared_[it->second.clock]) != digestOf(clock)) {
    return pathError(
        path + ".seconds",
        fmt::format("the button of parts[{}] starts the same signal '{}' with different settings",
                    it->second.part, name),
        "give both buttons the same 'seconds', 'forever' and 'restarts', or different signals");
  }
  return {};
}

Status ClockTables::addSignals(schema::Level::Reader level, const Params& params) {
  size_t index = 0;
  for (const auto part : level.getParts()) {
    if (part.hasButton() && part.getTouch()) {
      OBBY_RETURN_IF_ERROR(addButton(part, index, params));
    }
    ++index;
  }
  return {};
}

Result<uint32_t> ClockTables::signal(const std::string& name, const std::string& path) {
  if (name.empty()) return pathError(path, "expected the name of a button's signal, found none");
  const auto it = signals_.find(name);
  if (it == signals_.end()) {
    return pathError(path, fmt::format("no button starts the signal '{}'", name),
                     "add \"button\":{\"signal\":\"" + name + "\"} to a part that can be touched");
  }
  it->second.used = true;
  return it->second.clock | kShared;
}

uint32_t ClockTables::button(const std::string& name) const {
  return signals_.at(name).clock | kShared;
}

uint32_t ClockTables::add(const Clock& clock) {
  shared_.push_back(clock);
  return uint32_t(shared_.size() - 1) | kShared;
}

uint32_t ClockTables::share(const Clock& clock) {
  const auto [given, isNew] = given_.try_emplace(digestOf(clock), 0);
  if (isNew) given->second = add(clock);
  return given->second;
}

Status ClockTables::checkSignals() const {
  for (const auto& [name, signal] : signals_) {
    if (signal.used) continue;
    return pathError(
        fmt::format("parts[{}].button.signal", signal.part),
        fmt::format("no part responds to the signal '{}'", name),
        "set 'signal' to this name in the 'vanish' or 'motion' of a part, or remove the button");
  }
  return {};
}

std::vector<Clock> ClockTables::finish(const std::vector<Clock>& own,
                                       const std::vector<Collider>& colliders,
                                       std::vector<Roles>& roles,
                                       std::vector<Mover>& movers) const {
  for (uint32_t i = 0; i < roles.size(); ++i) {
    Roles& r = roles[i];
    for (uint32_t* clock : {&r.awayClock, &r.healClock, &r.seatClock}) {
      resolve(*clock, i, roles.size());
    }
    for (uint32_t& clock : r.starts) resolve(clock, i, roles.size());
  }
  std::vector<bool> done(movers.size(), false);  // hulls of one part share its mover
  for (const Collider& c : colliders) {
    if (c.mover == kNone || done[c.mover]) continue;
    done[c.mover] = true;
    resolve(movers[c.mover].trigger, c.role, roles.size());
  }
  std::vector<Clock> all = own;
  all.insert(all.end(), shared_.begin(), shared_.end());
  return all;
}

}  // namespace obby::level
