#include "calibrate/shortfall.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "calibrate/instants.h"
#include "calibrate/noise.h"

namespace obby::calibrate {

namespace {

constexpr double kSeconds = 0.5;  // length of a window
constexpr double kEnd = 0.005;    // distance from a bound that counts as at the bound, in shares
constexpr size_t kMaxNamed = 3;
constexpr double kLittle = 0.01;  // studs: smaller errors are not reported
constexpr double kElsewhere[] = {0.1, 0.3, 0.5, 0.7, 0.9};  // shares that are tried
constexpr double kNearer = 0.7;  // relative distance below which another value explains part of the
                                 // error

std::vector<std::string> endsOf(const Fit& fit) {
  std::vector<std::string> out;
  for (const Fitted& f : fit.parameters) {
    const double share = shareOf(f.parameter, f.value);
    const bool shown = f.low > f.parameter.lowest || f.high < f.parameter.highest;
    // A value of 0 is not at a lower end, since nothing lies below it.
    const bool none = f.parameter.lowest <= 0 || f.value <= 0;
    if (shown && ((share < kEnd && !none) || share > 1 - kEnd)) out.push_back(f.parameter.name);
  }
  return out;
}

// Measures the windows of one recording.
std::vector<Strange> windowsOff(std::span<const Take> takes, size_t index,
                                const std::vector<Window>& windows, const level::LevelView& level,
                                double delay) {
  const Take& take = takes[index];
  const auto& frames = take.track.frames;
  std::vector<Strange> out;
  for (const Window& w : windows)
    out.push_back({index, take.track.name, frames[w.first].time, frames[w.last].time});
  std::vector<double> max(windows.size(), 0);
  playBack(level, take.track, windows, delay,
           [&](uint32_t window, uint32_t frame, const Moment& now) {
             const double off = double(length(now.position - frames[frame].position));
             const Window& w = windows[window];
             out[window].off += off / double(w.last - w.first);
             if (off <= max[window]) return;
             max[window] = off;
             out[window].state = frames[frame].state;
           });
  return out;
}

// Returns the distance of the same window under other parameters.
Result<double> offUnder(std::span<const Take> takes, const Strange& strange, double delay,
                        schema::PhysicsParams::Reader params) {
  const Track& track = takes[strange.take].track;
  OBBY_ASSIGN(const level::Level level, levelWith(takes[strange.take], params));
  for (const Window& w : windowsOf(track, kSeconds, level.view())) {
    if (track.frames[w.first].time != strange.from) continue;
    return windowsOff(takes, strange.take, {w}, level.view(), delay).front().off;
  }
  return strange.off;
}

void addUntold(std::span<const Take> takes, const Fit& fit, schema::PhysicsParams::Reader params,
               Strange& strange) {
  for (const Fitted& f : fit.parameters) {
    if (f.low > f.parameter.lowest || f.high < f.parameter.highest) continue;
    for (const double share : kElsewhere) {
      io::RecordBuilder other;
      other.root().setParams(params);
      setValue(other.root().getParams(), f.parameter.name, valueAt(f.parameter, share));
      const auto off = offUnder(takes, strange, fit.delay, other.reader().getParams());
      if (!off || *off > kNearer * strange.off) continue;  // invalid, or explains too little
      strange.untold.push_back(f.parameter.name);
      break;
    }
  }
}

}  // namespace

Result<Shortfall> shortfallOf(std::span<const Take> recorded, const Fit& fit,
                              schema::PhysicsParams::Reader params, double tolerance) {
  const std::vector<Take> takes = withVelocitiesOfNow(recorded, params);
  Shortfall out{noiseOf(takes), endsOf(fit), {}, fit.stopped};
  if (out.stopped) return out;
  for (size_t i = 0; i < takes.size(); ++i) {
    OBBY_ASSIGN(const level::Level level, levelWith(takes[i], params));
    const auto windows = windowsOf(takes[i].track, kSeconds, level.view());
    for (const Strange& s : windowsOff(takes, i, windows, level.view(), fit.delay)) {
      if (s.off > std::max({tolerance, 2 * out.noise, kLittle})) out.strange.push_back(s);
    }
  }
  std::stable_sort(out.strange.begin(), out.strange.end(),
                   [](const Strange& a, const Strange& b) { return a.off > b.off; });
  out.strange.resize(std::min(out.strange.size(), kMaxNamed));
  for (Strange& s : out.strange) addUntold(takes, fit, params, s);
  return out;
}

std::string shortOf(const Shortfall& s, double tolerance) {
  if (s.stopped) return "the fit was interrupted";
  if (s.noise > tolerance)
    return fmt::format(
        "the recorded positions already jitter by {:.2g} studs from frame to frame, so no fit can "
        "be closer",
        s.noise);
  if (!s.strange.empty()) {
    const Strange& worst = s.strange.front();
    if (!worst.untold.empty())
      return fmt::format("the fitted recordings do not determine {}, on which '{}' depends",
                         fmt::join(worst.untold, ", "), worst.recording);
    return fmt::format("no parameter values explain '{}' from {:.2f} to {:.2f} s, in state {}",
                       worst.recording, worst.from, worst.to, nameOf(worst.state));
  }
  if (!s.ends.empty())
    return fmt::format("the best fit is at a limit of the range searched for {}",
                       fmt::join(s.ends, ", "));
  return "small errors add up";
}

namespace {

std::string causeOf(const Strange& w) {
  if (w.untold.empty()) return "with any parameter values";
  return fmt::format("because of {}, which the fitted recordings do not determine",
                     fmt::join(w.untold, " or "));
}

}  // namespace

std::vector<std::string> reasonsOf(const Shortfall& s, double tolerance) {
  std::vector<std::string> out;
  if (s.stopped) out.emplace_back("the fit was interrupted");
  if (s.noise > tolerance)
    out.push_back(
        fmt::format("the recorded positions already jitter by {:.2g} studs from frame to frame, so "
                    "no fit can be closer",
                    s.noise));
  for (const std::string& name : s.ends)
    out.push_back(fmt::format("the best fit is at a limit of the range searched for {}", name));
  for (const Strange& w : s.strange)
    out.push_back(
        fmt::format("'{}', {:.2f} to {:.2f} s: started as recorded, the simulator is {:.2g} studs "
                    "off in state {}, {}",
                    w.recording, w.from, w.to, w.off, nameOf(w.state), causeOf(w)));
  if (out.empty())
    out.emplace_back("no single half second exceeds the tolerance; small errors add up");
  return out;
}

}  // namespace obby::calibrate
