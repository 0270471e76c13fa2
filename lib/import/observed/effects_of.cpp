#include "import/observed/effects_of.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>

#include "engine/observation.h"
#include "import/document/pose_math.h"
#include "import/draft/world.h"
#include "import/observed/boost_effect.h"
#include "import/observed/own_changes.h"
#include "import/observed/progress.h"
#include "import/observed/roles.h"
#include "import/observed/tween_law.h"

namespace obby::importer {
namespace {

using engine::Change;
using engine::kPlayer;

constexpr double kNoCooldown = 0.1;          // seconds; shorter intervals do not count
constexpr float kYaw = 0.3f;                 // radians; yaw of a probe's player (moves.luau)
constexpr Vec3 kArriving = {1.5f, 0, 2.5f};  // studs/s; velocity of a probe's player
constexpr float kKept = 1e-3f;

// Returns true for settings that scripts use to disable a player's controls.
bool isStateOff(const std::string& property) {
  return property == "note state off Jumping" || property == "note state off Climbing" ||
         property == "note state off Running";
}

class Difference {
 public:
  Difference(const engine::Report& report, const engine::Probe& probe)
      : report_(report), probe_(probe), own_(changesByTouch(report, probe)) {}

  ProbeEffects effects() {
    findHarm();
    for (const Change* change : own_) take(*change);
    findEnd();
    findAways();
    findMoved();
    effects_.boost = boosterOf(report_, probe_, speeds_);
    return std::move(effects_);
  }

 private:
  // Returns the seconds since the first frame in which scripts can notice the touch.
  double after(double time) const { return std::max(0.0, time - probe_.at - engine::kFrame); }

  // Finds damage. If several limbs are hit in one frame, the damage is that of one limb.
  void findHarm() {
    const Hits hits = ownHits(probe_.seen.harms);
    if (hits.empty()) return;
    Harmful found;
    found.damage = hits[0].from - hits[0].to;
    found.stoppable = hits[0].stoppable;
    found.line = hits[0].line;
    const auto second = secondHit(hits), again = secondHit(ownHits(probe_.still.harms));
    const double between = std::min(second.value_or(probe_.left - hits[0].time),
                                    again.value_or(std::numeric_limits<double>::max()));
    const bool ends = second || again || probe_.seen.player.alive;
    if (between >= kNoCooldown && ends) found.cooldown = between;
    if (probe_.brief.harms.empty())
      findLasting(found, hits, probe_.left, second);
    else
      findLasting(found, ownHits(probe_.brief.harms), probe_.brief.left, second);
    effects_.harm = found;
  }

  using Hits = std::vector<engine::Harm>;
  // Returns the hits that neither the undisturbed run nor the player's moves explain.
  Hits ownHits(const Hits& seen) const {
    std::set<int64_t> usual;
    for (const engine::Harm& harm : report_.undisturbed.harms)
      if (harm.hurts()) usual.insert(std::llround(harm.time / engine::kFrame));
    std::set<engine::Line> walked;
    for (const engine::Probe* const move : movesBefore(report_, probe_))
      for (const engine::Harm& harm : move->seen.harms) walked.insert(harm.line);
    Hits own;
    for (const engine::Harm& harm : seen)
      if (harm.hurts() && !usual.contains(std::llround(harm.time / engine::kFrame)) &&
          !walked.contains(harm.line))
        own.push_back(harm);
    return own;
  }

  // Returns the seconds from the first hit to the next one in another frame.
  static std::optional<double> secondHit(const Hits& hits) {
    for (const engine::Harm& harm : hits)
      if (harm.time > hits[0].time) return harm.time - hits[0].time;
    return std::nullopt;
  }

  // Finds harm that goes on after the player has left. The damage of a touch is the sum of its
  // hits. `second`: seconds to the second hit if the player touches the part repeatedly. If
  // repeated touches do not hasten a hit, the cooldown lasts until the last hit of a touch.
  static void findLasting(Harmful& found, const Hits& hits, double left,
                          std::optional<double> second) {
    double total = 0;
    int later = 0;
    for (const engine::Harm& harm : hits) {
      total += harm.from - harm.to;
      later += left > 0 && harm.time > left + 2 * engine::kFrame;
    }
    const bool dies = later == 1 && hits.back().to <= 0;
    if (later <= 1 && !dies) return;
    const auto own = secondHit(hits);
    const bool waits = second && own && *second > *own - engine::kFrame;
    found.damage = total;
    found.cooldown = waits ? hits.back().time - hits[0].time : 0;
    found.lasts = true;
  }

  void take(const Change& change) {
    if (change.target == kPlayer) return takePlayer(change);
    const std::string& property = change.property;
    effects_.others.emplace(change.target, change.line);
    if (changesSpeed(change))
      speeds_.push_back(&change);
    else if (property == "note jump")
      takeJump(change);
    else if (property.rfind("note mover ", 0) == 0)
      takeMover(change);
    else if (property.rfind("note ", 0) == 0 && takeProgress(effects_, change, probe_.target))
      return;
    else if (property == "note sit" || property == "note state")
      takeState(change);
    else if (property == "note ends")
      effects_.ends = effects_.ends.value_or(change.line);
    else if (isStateOff(property))
      effects_.stateOff = effects_.stateOff.value_or(change.line);
    else if (property == "note walk")
      effects_.force = effects_.force.value_or(change.line);
    else if (property == "Velocity" && change.target < engine::kMade)
      effects_.belts.push_back({change.target, change.line});
    else if (property == "Size" && change.target < engine::kMade &&
             (effects_.sizes.empty() || effects_.sizes.back().part != change.target))
      effects_.sizes.push_back({change.target, change.line});
  }

  // Finds a touch after which the player cannot walk and no script waits.
  void findEnd() {
    const bool isStuck = probe_.seen.player.stuck && !report_.undisturbed.player.stuck;
    if (!isStuck || !probe_.seen.player.alive || probe_.sleeps) return;
    constexpr std::string_view kStopping[] = {"Anchored",  "PlatformStand", "note sit",
                                              "WalkSpeed", "note controls", "note state"};
    for (const Change* change : own_)
      if (std::find(std::begin(kStopping), std::end(kStopping), change->property) !=
          std::end(kStopping))
        effects_.ends = change->line;
  }

  void takePlayer(const Change& change) {
    const std::string& property = change.property;
    if (const Vec3* const velocity = std::get_if<Vec3>(&change.value);
        velocity && property == "Velocity")
      setPush(*velocity, change.line);
    else if (const Pose* const pose = std::get_if<Pose>(&change.value);
             pose && property == "CFrame")
      setTeleport(*pose, change.time, change.line);
    else if (changesSpeed(change))
      speeds_.push_back(&change);
    else if (property == "PlatformStand")
      takeState(change);
  }

  void setPush(Vec3 velocity, engine::Line line) {
    if (effects_.push) return;
    Push push;
    push.keepsSideways =
        std::abs(velocity.x - kArriving.x) < kKept && std::abs(velocity.z - kArriving.z) < kKept;
    push.velocity = velocity;
    push.line = line;
    effects_.push = push;
  }

  void setTeleport(const Pose& root, double time, engine::Line line) {
    // A move after the player has left belongs to its new place, not to this part.
    const bool left = probe_.left > 0 && time > probe_.left;
    if (effects_.teleport || left) return;
    constexpr float kRootHeight = 3;
    Teleported to;
    to.feet = root.position - Vec3{0, kRootHeight, 0};
    to.yaw = yawOf(-root.rotation.z);
    to.turns = std::abs(to.yaw - kYaw) > kKept;
    to.line = line;
    effects_.teleport = to;
  }

  // Reads a jump that a script causes, with the jump power at that time.
  void takeJump(const Change& change) {
    const double* const power = std::get_if<double>(&change.value);
    if (!power || effects_.push) return;
    const bool byPower = probe_.seen.player.usesJumpPower;
    const auto speed = float(byPower ? kJumpPowerGain * *power : std::sqrt(392.4 * *power));
    effects_.push = Push{{kArriving.x, speed, kArriving.z}, true, change.line};
  }

  void takeMover(const Change& change) {
    const Vec3* const velocity = std::get_if<Vec3>(&change.value);
    const bool sets = change.property.find("Velocity") != std::string::npos;
    if (change.property == "note mover end") {
      if (change.target == mover_ && effects_.push) effects_.push->seconds = change.time - moved_;
    } else if (velocity && sets) {
      // A script may set the velocity once the mover is there.
      if (mover_ == change.target && moved_ == change.time) effects_.push.reset();
      if (!effects_.push) mover_ = change.target, moved_ = change.time;
      setPush(*velocity, change.line);
      if (mover_ == change.target)
        effects_.push->seconds = probe_.seen.frames * engine::kFrame - moved_;
    } else {
      effects_.force = effects_.force.value_or(change.line);
    }
  }

  void takeState(const Change& change) {
    const bool* const flag = std::get_if<bool>(&change.value);
    const std::string* const state = std::get_if<std::string>(&change.value);
    const bool falls = state && (*state == "FallingDown" || *state == "Ragdoll" ||
                                 *state == "Physics" || *state == "PlatformStanding");
    if (state && *state == "Jumping" && !effects_.push) effects_.jumps = change.line;
    if (!(flag && *flag) && !falls) return;
    effects_.trips = change.line;
  }

  // Marks a part that comes back right after the player has left: it is away while it is touched.
  void comeBack(Away& away, double time) const {
    constexpr double kAtOnce = 0.35;  // seconds; polling scripts check a few times a second
    const double late = time - probe_.left;
    away.held = probe_.left > 0 && late >= -engine::kFrame && late < kAtOnce;
    away.seconds = away.held ? std::max(late, engine::kFrame) : after(time) - away.delay;
  }

  void findAways() {
    std::map<InstanceId, Away> found, came;
    for (const Change* change : own_) {
      // A part that becomes unanchored falls, so it no longer carries players.
      if (change->property != "CanCollide" && change->property != "Parent" &&
          change->property != "Anchored")
        continue;
      const bool* const solid = std::get_if<bool>(&change->value);
      if (!solid || change->target >= engine::kMade) continue;
      const auto known = found.find(change->target);
      const auto back = came.find(change->target);
      if (*solid && known == found.end() && back == came.end())
        came[change->target] = {change->target, after(change->time), std::nullopt, change->line};
      else if (!*solid && back != came.end() && !back->second.seconds)
        comeBack(back->second, change->time);
      else if (!*solid && known == found.end() && back == came.end())
        found[change->target] = {change->target, after(change->time), std::nullopt, change->line};
      else if (*solid && known != found.end() && !known->second.seconds)
        comeBack(known->second, change->time);
    }
    for (const auto& [id, away] : found) effects_.aways.push_back(away);
    for (const auto& [id, away] : came) effects_.backs.push_back(away);
  }

  void findMoved() {
    const auto first = uint32_t(std::llround(probe_.at / engine::kFrame)) + 1;
    const uint32_t frames = probe_.seen.frames >= first ? probe_.seen.frames - first + 1 : 0;
    const TweenLaws laws(probe_.seen, (first - 1) * engine::kFrame);
    for (const auto& [id, track] : probe_.seen.tracks) {
      if (id >= engine::kMade || frames == 0) continue;
      const auto usual = report_.undisturbed.tracks.find(id);
      const bool moves =
          usual != report_.undisturbed.tracks.end() && usual->second.poses.back().frame >= first;
      if (moves) continue;  // it moves anyway
      const Pose start = startOf(id, track);
      auto poses = posesOf(start, track, first, frames);
      poses.insert(poses.begin(), start);
      auto outlasting = laws.outlasting(poses, id);
      effects_.moved.push_back({id, std::move(poses), track.driver, moverOf(probe_.seen, id, track),
                                std::move(outlasting)});
    }
  }

  // Returns the pose before the touch: that of the undisturbed run, else that of the file.
  Pose startOf(InstanceId id, const engine::Track& track) const {
    const auto usual = report_.undisturbed.tracks.find(id);
    if (usual != report_.undisturbed.tracks.end()) return usual->second.poses.back().pose;
    return track.start;
  }

  const engine::Report& report_;
  const engine::Probe& probe_;
  std::vector<const Change*> own_;
  std::vector<const Change*> speeds_;
  ProbeEffects effects_;
  InstanceId mover_ = kNoInstance;  // mover that gives the push
  double moved_ = 0;                // time of the mover's start
};

}  // namespace

ProbeEffects effectsOf(const engine::Report& report, const engine::Probe& probe) {
  return Difference(report, probe).effects();
}

}  // namespace obby::importer
