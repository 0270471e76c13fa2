// Finds platforms that a kit's own script drives along waypoints: the tag MovingPlatform, or the
// `Positions` of the tower kits.
#include <algorithm>
#include <set>

#include "import/document/pivot.h"
#include "import/document/words.h"
#include "import/draft/motion.h"
#include "import/roles/role.h"

namespace obby::importer {
namespace {

const std::vector<std::string_view> kMovingTags = {"movingplatform", "moving platform", "mover",
                                                   "movingpart", "platformmover"};
const std::vector<std::string_view> kSpinTags = {
    "spinner", "spinning", "spin", "spinningpart", "rotating", "rotator", "spinningplatform"};
constexpr std::string_view kPathNames[] = {"checkpoints", "positions", "waypoints",
                                           "nodes",       "points",    "path"};
constexpr double kTemplateSpeed = 10, kTemplateDelay = 3;
constexpr double kKitDelay = 5, kKit6Delay = 2;
constexpr double kAlignTime = 1;     // approximate seconds of an AlignPosition, for any distance
constexpr double kDefaultSpin = 90;  // degrees/s

struct Waypoints {
  InstanceId folder = kNoInstance, platform = kNoInstance;
  std::vector<InstanceId> points;  // waypoints in order
};

Waypoints waypointsOf(const Tree& tree, InstanceId model) {
  Waypoints waypoints;
  for (InstanceId child : tree.at(model).children) {
    const std::string name = lower(tree.at(child).name);
    const bool isPath =
        std::find(std::begin(kPathNames), std::end(kPathNames), name) != std::end(kPathNames);
    if (isPath && !tree.isPart(child) && waypoints.folder == kNoInstance) waypoints.folder = child;
    if (name == "platform" || name == "movingpart") waypoints.platform = child;
  }
  if (waypoints.folder == kNoInstance) return waypoints;
  for (InstanceId child : tree.at(model).children)
    if (waypoints.platform == kNoInstance && child != waypoints.folder &&
        !tree.partsOf(child).empty())
      waypoints.platform = child;
  for (InstanceId point : tree.at(waypoints.folder).children)
    if (tree.isPart(point)) waypoints.points.push_back(point);
  const auto number = [&](InstanceId id) { return firstNumber(tree.at(id).name).value_or(0); };
  std::stable_sort(waypoints.points.begin(), waypoints.points.end(),
                   [&](InstanceId a, InstanceId b) { return number(a) < number(b); });
  return waypoints;
}

// Returns the round trip over the waypoints. If `speed` is 0, each segment takes kAlignTime.
Motion alongPoints(const Tree& tree, const Waypoints& waypoints, double speed, double delay) {
  Motion motion;
  motion.carries = true;
  double now = 0;
  const auto add = [&](const Pose& pose) {
    motion.keys.push_back({float(now), pose, Easing::linear, EasingDirection::out});
  };
  const Pose start = pivotOf(tree, waypoints.points.front());
  add(start);
  now += delay;
  add(start);
  for (size_t i = 1; i <= waypoints.points.size(); ++i) {
    const Pose pose = pivotOf(tree, waypoints.points[i % waypoints.points.size()]);
    const double distance = double(length(pose.position - motion.keys.back().pose.position));
    now +=
        speed > 0 ? std::max(distance / speed, 1e-3) : std::min(kAlignTime, std::max(delay, 0.1));
    add(pose);
    if (i == waypoints.points.size()) break;
    now += speed > 0 ? delay : std::max(0.0, delay - kAlignTime);
    add(pose);
  }
  return motion;
}

void give(RoleContext& context, const Waypoints& waypoints, double speed, double delay,
          const std::string& reason, bool guessed) {
  if (waypoints.platform == kNoInstance || waypoints.points.size() < 2) return;
  giveMotion(context, waypoints.platform, alongPoints(context.tree, waypoints, speed, delay),
             reason, guessed);
  for (InstanceId point : waypoints.points) {
    PartDraft* part = context.part(point);
    if (!part || part->motion) continue;
    part->solid = part->touch = false;
    part->evidence.push_back(
        {"marker", "waypoint of " + context.tree.path(waypoints.platform), false});
  }
}

}  // namespace

void movingFromTags(RoleContext& context) {
  const Tree& tree = context.tree;
  context.eachTagged(kMovingTags, [&](InstanceId id, const std::string& tag) {
    const Waypoints waypoints = waypointsOf(tree, id);
    const auto speed = tree.number(id, "speed");
    if (waypoints.points.size() < 2) {
      context.level.noteUnmodelled(
          "moving platform without waypoints", tree, id,
          "tag " + tag + "; the platform stays at its position in the file");
      return;
    }
    give(context, waypoints, std::max(speed.value_or(kTemplateSpeed), 0.1),
         std::clamp(tree.number(id, "delay").value_or(kTemplateDelay), 0.0, 60.0), "tag " + tag,
         !speed);
  });
  context.eachTagged(kSpinTags, [&](InstanceId id, const std::string& tag) {
    auto speed = tree.number(id, "Speed");
    if (!speed) speed = tree.number(id, "RotationSpeed");
    Motion motion;
    motion.spin = Spin{{0, 1, 0}, float(speed.value_or(kDefaultSpin) * 3.14159265358979 / 180), {}};
    giveMotion(context, id, motion, "tag " + tag + "; its speed is read as degrees/s", true);
  });
}

void movingFromMarkers(RoleContext& context) {
  const Tree& tree = context.tree;
  std::set<InstanceId> known;  // the first of several routes of one model counts
  for (InstanceId id = 0; id < tree.size(); ++id) {
    if (tree.at(id).name != "Positions" || tree.isPart(id) || tree.at(id).parent == kNoInstance)
      continue;
    const InstanceId model = tree.at(id).parent;
    if (!known.insert(model).second) continue;
    const bool touchStarts = tree.flag(model, "TouchActivated").value_or(false);
    auto delay = tree.number(model, "MoveDelay");
    const bool old = !delay && tree.number(model, "Delay");
    if (!delay) delay = tree.number(model, "Delay");
    const Waypoints waypoints = waypointsOf(tree, model);
    if (touchStarts && waypoints.points.size() >= 2)
      context.level.noteUnmodelled("motion that a touch or click starts", tree, model,
                                   "simulated as always moving");
    give(context, waypoints, 0, std::clamp(delay.value_or(old ? kKitDelay : kKit6Delay), 0.1, 60.0),
         "marker Positions", true);
  }
}

}  // namespace obby::importer
