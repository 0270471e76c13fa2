#include "level/motion_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "level/record_values.h"

namespace obby::level {
namespace {

constexpr double kTurn = 2 * 3.14159265358979323846;  // radians

// Interpolates along the shorter arc between two rotations. Keys may be far apart, so the
// interpolation is spherical.
Quat slerp(Quat a, Quat b, double t) {
  double d = double(a.x) * b.x + double(a.y) * b.y + double(a.z) * b.z + double(a.w) * b.w;
  const double sign = d < 0 ? -1 : 1;
  d *= sign;
  double wa = 1 - t, wb = t;
  if (d < 0.9995) {
    const double angle = std::acos(d);
    wa = std::sin((1 - t) * angle) / std::sin(angle);
    wb = std::sin(t * angle) / std::sin(angle);
  }
  wb *= sign;
  const auto mix = [&](float u, float v) {
    return float(std::round((wa * u + wb * v) * 1e7) / 1e7);
  };
  return normalize(Quat{mix(a.x, b.x), mix(a.y, b.y), mix(a.z, b.z), mix(a.w, b.w)});
}

Result<std::vector<MotionKey>> readKeys(schema::Motion::Reader motion) {
  std::vector<MotionKey> keys;
  for (const auto record : motion.getKeys()) {
    const std::string path = fmt::format("motion.keys[{}]", keys.size());
    const double time = record.getTime();
    if (!std::isfinite(time) || time < (keys.empty() ? 0.0 : keys.back().time)) {
      return pathError(path + ".time",
                       "expected 0 or more seconds, not earlier than the previous key, found " +
                           shown(record.getTime()));
    }
    OBBY_ASSIGN(const Vec3 at, position(record.getPosition(), path + ".position"));
    OBBY_ASSIGN(const Quat turned, quaternion(record.getRotation(), path + ".rotation"));
    keys.push_back({time, at, turned, record.getEasing(), record.getDirection()});
  }
  return keys;
}

// Returns the pose at `time` seconds into one run through the keys.
Pose poseAt(const std::vector<MotionKey>& keys, double time) {
  const auto later = [](double t, const MotionKey& key) { return t < key.time; };
  const size_t next =
      size_t(std::upper_bound(keys.begin(), keys.end(), time, later) - keys.begin());
  if (next == 0) return {keys[0].position, toMat3(keys[0].rotation)};
  if (next == keys.size()) return {keys.back().position, toMat3(keys.back().rotation)};
  const MotionKey &a = keys[next - 1], &b = keys[next];
  const double t = ease(b.easing, b.direction, (time - a.time) / (b.time - a.time));
  return {a.position + (b.position - a.position) * float(t),
          toMat3(slerp(a.rotation, b.rotation, t))};
}

// Returns the number of rows that hold whole repetitions of a period with the smallest drift.
uint32_t rowsFor(double periodTicks, uint32_t maxRows) {
  uint32_t best = 0;
  double bestError = 1e9;
  for (int k = 1; k <= 256 && (k == 1 || k * periodTicks <= maxRows); ++k) {
    const double rows = std::round(k * periodTicks);
    const double error = std::fabs(rows - k * periodTicks) / k;
    if (rows >= 1 && error < bestError - 1e-9) best = uint32_t(rows), bestError = error;
    if (bestError < 0.002) break;
  }
  return best;
}

Status planKeys(schema::Motion::Reader motion, const Params& params, uint32_t maxRows,
                MotionPlan& plan) {
  const double length = plan.keys.back().time - plan.keys.front().time;
  plan.pingPong = motion.getRepeat() == schema::Repeat::PING_PONG;
  plan.once = motion.getRepeat() == schema::Repeat::ONCE;
  plan.seconds = plan.pingPong ? 2 * length : length;
  const double ticks = plan.seconds * params.controlRate;
  if (ticks > maxTicks(params)) {
    return pathError("motion.keys", "one pass through the keys takes " + longerThanMax(params));
  }
  // A negative offset is a wait before the motion. A motion that runs once must still reach its
  // end.
  const double wait = plan.once ? std::max(0.0, -plan.offset) * params.controlRate : 0;
  if (wait > maxTicks(params)) {
    return pathError("motion.offset", "the wait before the motion is " + longerThanMax(params));
  }
  const uint32_t rows = plan.once ? uint32_t(ticks + wait) + 2 : rowsFor(ticks, maxRows);
  if (length <= 0 || rows == 0) return {};
  // The table holds whole repetitions. Rounding stretches time by far too little to be visible.
  const double repetitions = plan.once ? 1 : std::max(1.0, std::round(rows / ticks));
  plan.secondsPerRow = plan.once ? 1.0 / params.controlRate : repetitions * plan.seconds / rows;
  plan.rows = rows;
  plan.period = plan.once ? rows : uint32_t(std::lround(ticks));
  return {};
}

Status planSpin(schema::Spin::Reader spin, const Params& params, uint32_t maxRows,
                MotionPlan& plan) {
  OBBY_ASSIGN(plan.spin.axis, direction(spin.getAxis(), "motion.spin.axis"));
  if (!std::isfinite(spin.getSpeed()))
    return pathError("motion.spin.speed",
                     "expected a finite speed in rad/s, found " + shown(spin.getSpeed()));
  OBBY_ASSIGN(plan.pivot, position(spin.getPivot(), "motion.spin.pivot"));
  const double speed = spin.getSpeed();
  if (std::fabs(speed) < 1e-4) return {};
  const double ticks = kTurn / std::fabs(speed) * params.controlRate;
  if (ticks > maxTicks(params))
    return pathError("motion.spin.speed", "one turn takes " + longerThanMax(params));
  plan.spin.speed = speed;
  plan.spin.offset = plan.offset;
  plan.spin.rows = std::max(1u, rowsFor(ticks, maxRows));
  plan.spin.turns = std::max(1.0, std::round(plan.spin.rows / ticks));
  if (plan.period == 0) plan.period = uint32_t(std::lround(ticks));
  return {};
}

}  // namespace

std::string longerThanMax(const Params& params) {
  return fmt::format("longer than the allowed {:.0f} minutes",
                     maxTicks(params) / params.controlRate / 60);
}

Result<MotionPlan> planMotion(schema::Motion::Reader motion, const Params& params,
                              uint32_t maxRows) {
  MotionPlan plan;
  OBBY_ASSIGN(plan.keys, readKeys(motion));
  plan.offset = motion.getOffset();
  if (!std::isfinite(plan.offset))
    return pathError("motion.offset",
                     "expected a finite number of seconds, found " + shown(motion.getOffset()));
  if (!plan.keys.empty()) OBBY_RETURN_IF_ERROR(planKeys(motion, params, maxRows, plan));
  if (motion.hasSpin()) OBBY_RETURN_IF_ERROR(planSpin(motion.getSpin(), params, maxRows, plan));
  return plan;
}

std::vector<Pose> keyTable(const MotionPlan& plan, const Pose& rest) {
  if (plan.keys.empty()) return {rest};
  const double first = plan.keys.front().time, last = plan.keys.back().time;
  if (plan.rows == 0) return {poseAt(plan.keys, last)};
  std::vector<Pose> table;
  table.reserve(plan.rows);
  for (uint32_t row = 0; row < plan.rows; ++row) {
    double time = plan.offset + row * plan.secondsPerRow;
    if (!plan.once) time = std::fmod(std::fmod(time, plan.seconds) + plan.seconds, plan.seconds);
    if (plan.pingPong && time > last - first) time = plan.seconds - time;
    table.push_back(poseAt(plan.keys, first + time));
  }
  return table;
}

std::vector<Mat3> spinTable(const SpinPlan& plan) {
  const auto r7 = [](double v) { return float(std::round(v * 1e7) / 1e7); };
  const Vec3 n = plan.axis;
  std::vector<Mat3> table;
  table.reserve(plan.rows);
  for (uint32_t row = 0; row < plan.rows; ++row) {
    const double angle =
        plan.turns * kTurn * row / plan.rows * (plan.speed < 0 ? -1 : 1) + plan.speed * plan.offset;
    const float s = r7(std::sin(angle / 2));
    table.push_back(toMat3(normalize(Quat{n.x * s, n.y * s, n.z * s, r7(std::cos(angle / 2))})));
  }
  return table;
}

}  // namespace obby::level
