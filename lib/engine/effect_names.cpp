#include "engine/effect_names.h"

#include <algorithm>
#include <limits>
#include <map>
#include <vector>

namespace obby::engine {
namespace {

std::string nameOf(const Change& change) {
  return std::to_string(change.target) + "." + change.property;
}

std::string textOf(const Plain& value) {
  if (const bool* const flag = std::get_if<bool>(&value)) return *flag ? "=true" : "=false";
  if (const double* const number = std::get_if<double>(&value))
    return "=" + std::to_string(*number);
  return {};
}

bool isSame(const Pose& a, const Pose& b) {
  return length(a.position - b.position) < 0.1f &&
         length(a.rotation.x - b.rotation.x) + length(a.rotation.y - b.rotation.y) < 0.1f;
}

bool lacks(const Names& all, const std::string& effect) {
  const bool ends = effect[0] == '~';
  return !all.contains(effect) && !all.contains(ends ? effect.substr(1) : "~" + effect);
}

}  // namespace

bool harms(const Probe& probe) {
  return std::any_of(probe.seen.harms.begin(), probe.seen.harms.end(),
                     [](const Harm& harm) { return harm.hurts(); });
}

bool kills(const Probe& probe) { return harms(probe) && !probe.seen.player.alive; }

Names namesIn(const Observation& seen) {
  return namesIn(seen, 0, std::numeric_limits<double>::infinity());
}

Names namesIn(const Observation& seen, double from, double to) {
  const auto isIn = [&](double time) { return time >= from && time <= to; };
  Names names;
  for (const Change& change : seen.changes)
    if (isIn(change.time)) names.insert(nameOf(change));
  for (const auto& [id, track] : seen.tracks)
    if (std::any_of(track.poses.begin(), track.poses.end(),
                    [&](const Placed& placed) { return isIn(placed.frame * kFrame); }))
      names.insert(std::to_string(id));
  for (const Harm& harm : seen.harms)
    if (harm.hurts() && isIn(harm.time)) names.insert("harm");
  return names;
}

void drop(Observation& seen, const Names& names) {
  std::erase_if(seen.changes, [&](const Change& change) { return names.contains(nameOf(change)); });
  std::erase_if(seen.tracks,
                [&](const auto& track) { return names.contains(std::to_string(track.first)); });
  if (names.contains("harm"))
    std::erase_if(seen.harms, [](const Harm& harm) { return harm.hurts(); });
}

Names effectsIn(const Probe& probe, const Names& usual) {
  static const char* const kCounted[] = {"CanCollide", "Parent",    "WalkSpeed",     "JumpPower",
                                         "JumpHeight", "Gravity",   "PlatformStand", "note sit",
                                         "note state", "note jump", "note lift"};
  Names effects;
  if (harms(probe) && !usual.contains("harm")) effects.insert("~harm");
  std::map<std::string, std::vector<std::string>> values;
  for (const Change& change : probe.seen.changes) {
    const std::string name = nameOf(change), &property = change.property;
    if (usual.contains(name)) continue;
    const bool moves = property == "Velocity" || property == "CFrame";
    if (change.target == kPlayer && moves && change.time <= probe.left)
      effects.insert("~player " + property);
    else if (property.rfind("note mover ", 0) == 0)
      effects.insert("~" + property);
    else if (property == "note respawn" || property == "note team" ||
             (property == "note kept" && change.target == probe.target) ||
             property.rfind("note stat ", 0) == 0)
      effects.insert("stage");
    else if (std::find(std::begin(kCounted), std::end(kCounted), property) != std::end(kCounted))
      values[name].push_back(textOf(change.value));
  }
  for (const auto& [name, all] : values)
    effects.insert((all.size() > 1 && all.front() != all.back() ? "~" : "") + name + all.front());
  for (const auto& [id, track] : probe.seen.tracks)
    if (!usual.contains(std::to_string(id)))
      effects.insert((isSame(track.start, track.poses.back().pose) ? "~moves " : "moves ") +
                     std::to_string(id));
  return effects;
}

bool adds(const Names& before, const Names& now) {
  return std::any_of(now.begin(), now.end(),
                     [&](const std::string& effect) { return lacks(before, effect); });
}

bool differ(const Names& before, const Names& now) {
  return adds(before, now) ||
         std::any_of(before.begin(), before.end(), [&](const std::string& effect) {
           return effect[0] == '~' && lacks(now, effect);
         });
}

}  // namespace obby::engine
