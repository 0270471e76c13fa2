#include "calibrate/objective.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "io/physics.h"

namespace obby::calibrate {

namespace {

constexpr double kEarliest = -0.05, kLatest = 0.15;  // range of the delay, seconds
constexpr double kParted = 0.5;                      // studs

// Cauchy's loss: half the square of a small error, and logarithmic for large ones.
double costOf(double error, double near) {
  return 0.5 * near * near * std::log1p((error / near) * (error / near));
}

}  // namespace

Result<level::Level> levelWith(const Take& take, schema::PhysicsParams::Reader params) {
  io::RecordBuilder record(take.level.reader());
  auto level = record.root().getLevel();
  io::applyParams(params, level);
  return level::Level::compile(level.asReader());
}

Objective::Objective(std::span<const Take> takes, std::vector<Parameter> parameters,
                     schema::PhysicsParams::Reader now, const ObjectiveSettings& settings)
    : takes_(takes), parameters_(std::move(parameters)), settings_(settings) {
  now_.root().setParams(now);
}

size_t Objective::frames() const {
  size_t sum = 0;
  for (const Take& take : takes_) sum += take.track.frames.size() - 1;
  return sum;
}

double Objective::controlRate() const { return double(now_.reader().getParams().getControlRate()); }

void Objective::apply(std::span<const double> point, schema::PhysicsParams::Builder to) const {
  for (size_t i = 0; i < parameters_.size(); ++i)
    setValue(to, parameters_[i].name, valueAt(parameters_[i], point[i]));
}

double Objective::delayAt(std::span<const double> point) const {
  return kEarliest + (kLatest - kEarliest) * std::clamp(point[parameters_.size()], 0.0, 1.0);
}

Objective Objective::of(std::span<const Take> takes) const {
  return Objective(takes, parameters_, now_.reader().getParams(), settings_);
}

Objective Objective::of(std::vector<Parameter> parameters) const {
  return Objective(takes_, std::move(parameters), now_.reader().getParams(), settings_);
}

Objective Objective::from(std::span<const double> point, std::vector<Parameter> parameters) const {
  io::RecordBuilder params(now_.reader());
  apply(point, params.root().getParams());
  return Objective(takes_, std::move(parameters), params.reader().getParams(), settings_);
}

std::vector<double> Objective::start() const { return pointAt(now_.reader().getParams(), 0); }

std::vector<double> Objective::pointAt(schema::PhysicsParams::Reader params, double delay) const {
  std::vector<double> out;
  for (const Parameter& p : parameters_) out.push_back(shareOf(p, valueOf(params, p.name)));
  out.push_back((delay - kEarliest) / (kLatest - kEarliest));
  return out;
}

std::vector<double> Objective::delayShares(double step) const {
  std::vector<double> out;
  const int steps = int((kLatest - kEarliest) / step);
  for (int i = 0; i <= steps; ++i) out.push_back(i * step / (kLatest - kEarliest));
  return out;
}

Result<level::Level> Objective::levelAt(std::span<const double> point, const Take& take) const {
  io::RecordBuilder params(now_.reader());
  apply(point, params.root().getParams());
  return levelWith(take, params.reader().getParams());
}

Result<std::vector<float>> Objective::residuals(std::span<const double> point) const {
  std::vector<float> out;
  const double delay = delayAt(point);
  const float speed = float(settings_.speedSeconds), reach = float(settings_.reach);
  std::optional<level::Level> level;
  const Take* before = nullptr;
  for (const Take& take : takes_) {
    // Consecutive takes share a compiled level, since compiling takes longer than simulating.
    if (!before || &before->level.storage() != &take.level.storage()) {
      OBBY_ASSIGN(level, levelAt(point, take));
    }
    before = &take;
    const level::LevelView& view = level->view();
    const double seconds = settings_.windowSeconds > 0 ? settings_.windowSeconds : 1e30;
    const auto windows = windowsOf(take.track, seconds, view);
    const size_t first = out.size();
    const auto& frames = take.track.frames;
    out.resize(first + (frames.size() - 1) * kResiduals);
    playBack(view, take.track, windows, delay, [&](uint32_t, uint32_t frame, const Moment& now) {
      float* to = out.data() + first + (frame - 1) * kResiduals;
      const Frame& then = frames[frame];
      const Vec3 p = now.position - then.position;
      const Vec3 v = (now.velocity - then.velocity) * speed;
      const bool faces = then.facing.x != 0 || then.facing.z != 0;
      const Vec3 f = faces ? (now.facing - then.facing) * reach : Vec3{};
      for (const float r : {p.x, p.y, p.z, v.x, v.y, v.z, f.x, f.z}) *to++ = r;
    });
  }
  return out;
}

double Objective::loss(std::span<const double> point) const {
  const auto all = residuals(point);
  if (!all) return std::numeric_limits<double>::max();
  if (all->empty()) return 0;
  double sum = 0;
  for (const float r : *all) sum += costOf(double(r), settings_.near);
  // A NaN compares false with every loss, so it must not become the minimum.
  if (!std::isfinite(sum)) return std::numeric_limits<double>::max();
  return sum / double(all->size() / kResiduals);
}

Result<Path> pathOf(const Take& take, schema::PhysicsParams::Reader params, double delay) {
  OBBY_ASSIGN(const level::Level level, levelWith(take, params));
  const auto& frames = take.track.frames;
  Path out;
  playBack(level.view(), take.track, {{0, uint32_t(frames.size()) - 1}}, delay,
           [&](uint32_t, uint32_t frame, const Moment& now) {
             out.seconds.push_back(frames[frame].time);
             out.recorded.push_back(frames[frame].position);
             out.simulated.push_back(now.position);
           });
  return out;
}

Miss missOf(const Path& path) {
  Miss out;
  const size_t count = path.seconds.size();
  for (size_t i = 0; i < count; ++i) {
    const double off = double(length(path.simulated[i] - path.recorded[i]));
    out.mean += off / double(count);
    out.max = std::max(out.max, off);
    out.last = off;
    if (off > kParted && out.parted < 0) out.parted = path.seconds[i];
  }
  return out;
}

}  // namespace obby::calibrate
