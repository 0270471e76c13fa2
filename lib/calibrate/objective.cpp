#include "calibrate/objective.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace obby::calibrate {

namespace {

constexpr double kEarliest = -0.05, kLatest = 0.15;  // seconds of delay that are tried
constexpr double kParted = 0.5;                      // studs

Result<level::Level> levelWith(const Take& take, schema::PhysicsParams::Reader params) {
  io::RecordBuilder record(take.level.reader());
  auto level = record.root().getLevel();
  level.setPhysics(params);
  return level::Level::compile(level.asReader());
}

double huber(double error, double near) {
  const double size = std::fabs(error);
  return size <= near ? 0.5 * size * size : near * (size - 0.5 * near);
}

}  // namespace

Objective::Objective(std::span<const Take> takes, std::vector<Parameter> parameters,
                     schema::PhysicsParams::Reader now, const ObjectiveSettings& settings)
    : takes_(takes), parameters_(std::move(parameters)), settings_(settings) {
  now_.root().setParams(now);
}

void Objective::apply(std::span<const double> point, schema::PhysicsParams::Builder to) const {
  for (size_t i = 0; i < parameters_.size(); ++i)
    setValue(to, parameters_[i].name, valueAt(parameters_[i], point[i]));
}

double Objective::delayAt(std::span<const double> point) const {
  return kEarliest + (kLatest - kEarliest) * std::clamp(point[parameters_.size()], 0.0, 1.0);
}

std::vector<double> Objective::start() const {
  std::vector<double> out;
  for (const Parameter& p : parameters_)
    out.push_back(shareOf(p, valueOf(now_.reader().getParams(), p.name)));
  out.push_back(-kEarliest / (kLatest - kEarliest));
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
  const float speed = float(settings_.speedSeconds);
  for (const Take& take : takes_) {
    OBBY_ASSIGN(const level::Level level, levelAt(point, take));
    const level::LevelView& view = level.view();
    const double seconds = settings_.windowSeconds > 0 ? settings_.windowSeconds : 1e30;
    const auto windows = windowsOf(take.track, seconds, view.looseCount > 0);
    const size_t first = out.size();
    const auto& frames = take.track.frames;
    out.resize(first + (frames.size() - 1) * kResiduals);
    playBack(view, take.track, windows, delay,
             [&](uint32_t, uint32_t frame, Vec3 position, Vec3 velocity) {
               float* to = out.data() + first + (frame - 1) * kResiduals;
               const Vec3 p = position - frames[frame].position;
               const Vec3 v = (velocity - frames[frame].velocity) * speed;
               for (const float r : {p.x, p.y, p.z, v.x, v.y, v.z}) *to++ = r;
             });
  }
  return out;
}

double Objective::loss(std::span<const double> point) const {
  const auto all = residuals(point);
  if (!all) return std::numeric_limits<double>::max();
  double sum = 0;
  for (const float r : *all) sum += huber(double(r), settings_.near);
  return sum / double(all->size() / kResiduals);
}

Result<Miss> missOf(const Take& take, schema::PhysicsParams::Reader params, double delay) {
  OBBY_ASSIGN(const level::Level level, levelWith(take, params));
  const auto& frames = take.track.frames;
  Miss out;
  playBack(level.view(), take.track, {{0, uint32_t(frames.size()) - 1}}, delay,
           [&](uint32_t, uint32_t frame, Vec3 position, Vec3) {
             const double off = double(length(position - frames[frame].position));
             out.mean += off / double(frames.size() - 1);
             out.most = std::max(out.most, off);
             out.last = off;
             if (off > kParted && out.parted < 0) out.parted = frames[frame].time;
           });
  return out;
}

}  // namespace obby::calibrate
