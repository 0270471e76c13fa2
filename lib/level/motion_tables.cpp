#include "level/motion_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "level/record_values.h"

namespace obby::level {
namespace {

struct Key {
  double time;  // seconds
  Vec3 position;
  Quat rotation;
  schema::Easing easing;
  schema::EasingDirection direction;
};

// Shorter way round between two rotations; the angle between neighbouring rows is small, so that
// normalised linear interpolation after a spherical step would add nothing: keys may be far apart,
// hence spherical.
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

Result<std::vector<Key>> readKeys(schema::Motion::Reader motion) {
  std::vector<Key> keys;
  for (const auto record : motion.getKeys()) {
    const std::string path = fmt::format("motion.keys[{}]", keys.size());
    const double time = record.getTime();
    if (!std::isfinite(time) || time < (keys.empty() ? 0.0 : keys.back().time)) {
      return pathError(path + ".time", "expected seconds that do not decrease");
    }
    OBBY_ASSIGN(const Vec3 at, position(record.getPosition(), path + ".position"));
    OBBY_ASSIGN(const Quat turned, quaternion(record.getRotation(), path + ".rotation"));
    keys.push_back({time, at, turned, record.getEasing(), record.getDirection()});
  }
  return keys;
}

// The pose at `time` seconds into one run through the keys.
Pose poseAt(const std::vector<Key>& keys, double time) {
  const auto later = [](double t, const Key& key) { return t < key.time; };
  const size_t next =
      size_t(std::upper_bound(keys.begin(), keys.end(), time, later) - keys.begin());
  if (next == 0) return {keys[0].position, toMat3(keys[0].rotation)};
  if (next == keys.size()) return {keys.back().position, toMat3(keys.back().rotation)};
  const Key &a = keys[next - 1], &b = keys[next];
  const double t = ease(b.easing, b.direction, (time - a.time) / (b.time - a.time));
  return {a.position + (b.position - a.position) * float(t),
          toMat3(slerp(a.rotation, b.rotation, t))};
}

// Rows that hold whole repetitions of a period with the least drift.
uint32_t rowsFor(double periodTicks) {
  uint32_t best = 0;
  double bestError = 1e9;
  for (int k = 1; k <= 256 && (k == 1 || k * periodTicks <= kMaxRows); ++k) {
    const double rows = std::round(k * periodTicks);
    const double error = std::fabs(rows - k * periodTicks) / k;
    if (rows >= 1 && error < bestError - 1e-9) best = uint32_t(rows), bestError = error;
    if (bestError < 0.002) break;
  }
  return best;
}

Status keyTable(const std::vector<Key>& keys, schema::Motion::Reader motion, const Params& params,
                MotionTables& out) {
  const double length = keys.back().time - keys.front().time;
  const bool pingPong = motion.getRepeat() == schema::Repeat::PING_PONG;
  out.once = motion.getRepeat() == schema::Repeat::ONCE;
  const double period = pingPong ? 2 * length : length;
  const double ticks = period * params.controlRate;
  if (ticks > mostTicks(params)) {
    return pathError("motion.keys", "a round takes " + longerThanMost(params));
  }
  // A negative offset is a wait before the motion; one that comes but once must still arrive.
  const double wait =
      out.once ? std::max(0.0, -double(motion.getOffset())) * params.controlRate : 0;
  if (wait > mostTicks(params)) {
    return pathError("motion.offset", "a wait " + longerThanMost(params));
  }
  const uint32_t rows = out.once ? uint32_t(ticks + wait) + 2 : rowsFor(ticks);
  if (length <= 0 || rows == 0) {
    out.keys = {poseAt(keys, keys.back().time)};
    return {};
  }
  // Whole repetitions in the table: stretch time by the rounding, far below anything visible.
  const double repetitions = out.once ? 1 : std::max(1.0, std::round(rows / ticks));
  const double secondsPerRow = out.once ? 1.0 / params.controlRate : repetitions * period / rows;
  for (uint32_t row = 0; row < rows; ++row) {
    double time = motion.getOffset() + row * secondsPerRow;
    if (!out.once) time = std::fmod(std::fmod(time, period) + period, period);
    if (pingPong && time > length) time = period - time;
    out.keys.push_back(poseAt(keys, keys.front().time + time));
  }
  out.period = out.once ? rows : uint32_t(std::lround(ticks));
  return {};
}

Status spinTable(schema::Spin::Reader spin, double offset, const Params& params,
                 MotionTables& out) {
  OBBY_ASSIGN(const Vec3 n, direction(spin.getAxis(), "motion.spin.axis"));
  if (!std::isfinite(spin.getSpeed())) return pathError("motion.spin.speed", "expected rad/s");
  OBBY_ASSIGN(out.pivot, position(spin.getPivot(), "motion.spin.pivot"));
  const double speed = spin.getSpeed();
  if (std::fabs(speed) < 1e-4) return {};
  const double turn = 2 * 3.14159265358979323846;
  const double ticks = turn / std::fabs(speed) * params.controlRate;
  if (ticks > mostTicks(params))
    return pathError("motion.spin.speed", "a turn takes " + longerThanMost(params));
  const uint32_t rows = std::max(1u, rowsFor(ticks));
  const double turns = std::max(1.0, std::round(rows / ticks));
  if (out.period == 0) out.period = uint32_t(std::lround(ticks));
  for (uint32_t row = 0; row < rows; ++row) {
    const double angle = turns * turn * row / rows * (speed < 0 ? -1 : 1) + speed * offset;
    const auto r7 = [](double v) { return float(std::round(v * 1e7) / 1e7); };
    const float s = r7(std::sin(angle / 2));
    out.spins.push_back(
        toMat3(normalize(Quat{n.x * s, n.y * s, n.z * s, r7(std::cos(angle / 2))})));
  }
  return {};
}

}  // namespace

std::string longerThanMost(const Params& params) {
  return fmt::format("longer than {:.0f} minutes", mostTicks(params) / params.controlRate / 60);
}

Result<MotionTables> motionTables(schema::Motion::Reader motion, const Pose& rest,
                                  const Params& params) {
  MotionTables out;
  OBBY_ASSIGN(const std::vector<Key> keys, readKeys(motion));
  if (!std::isfinite(motion.getOffset())) return pathError("motion.offset", "expected seconds");
  if (keys.empty()) {
    out.keys = {rest};
  } else {
    OBBY_RETURN_IF_ERROR(keyTable(keys, motion, params, out));
  }
  if (motion.hasSpin())
    OBBY_RETURN_IF_ERROR(spinTable(motion.getSpin(), motion.getOffset(), params, out));
  return out;
}

}  // namespace obby::level
