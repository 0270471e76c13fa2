#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <limits>

#include "cli/console.h"
#include "io/json_writer.h"
#include "io/sink.h"
#include "io/text.h"
#include "io/utf8.h"

namespace obby::cli {
namespace {

// Returns the seconds between two progress reports.
double interval(ProgressMode mode) {
  switch (mode) {
    case ProgressMode::bar: return 0.1;
    case ProgressMode::json: return 0.2;
    case ProgressMode::line: return 10;
    case ProgressMode::none: break;
  }
  return std::numeric_limits<double>::infinity();
}

// Formats 1234567 as 1.23M.
std::string brief(double value) {
  const char* units[] = {"", "k", "M", "G", "T", "P"};
  size_t unit = 0;
  while (std::fabs(value) >= 1000 && unit < 5) {
    value /= 1000;
    unit++;
  }
  return unit == 0 ? fmt::format("{:g}", std::round(value * 100) / 100)
                   : fmt::format("{:.3g}{}", value, units[unit]);
}

// Formats 12400 s as 3 h 26 min.
std::string briefTime(double seconds) {
  constexpr double kMinute = 60, kHour = 60 * kMinute, kDay = 24 * kHour;
  if (seconds >= 2 * kDay) return brief(seconds / kDay) + " days";
  const double hours = std::floor(seconds / kHour);
  const double minutes = std::floor((seconds - hours * kHour) / kMinute);
  if (hours > 0) return fmt::format("{:.0f} h {:.0f} min", hours, minutes);
  return minutes > 0 ? fmt::format("{:.0f} min", minutes)
                     : fmt::format("{:.0f} s", std::floor(seconds));
}

bool knowsTime(const ProgressState& state) {
  return state.secondsLeft >= 0 && std::isfinite(state.secondsLeft);
}

}  // namespace

ProgressMode progressMode(const std::string& text, bool canDraw, bool quiet) {
  if (text == "json") return ProgressMode::json;
  if (quiet || text == "none") return ProgressMode::none;
  if (canDraw) return ProgressMode::bar;
  return text == "line" ? ProgressMode::line : ProgressMode::none;
}

std::string progressLine(const ProgressState& state, size_t width) {
  std::string out = io::tamed(state.task, false, '?');
  if (state.fraction >= 0) out += fmt::format("  {:.0f} %", 100 * std::fmin(state.fraction, 1));
  for (const auto& [name, value] : state.numbers) out += fmt::format("  {} {}", name, brief(value));
  if (knowsTime(state)) out += "  " + briefTime(state.secondsLeft) + " left";
  return std::string(io::cutAtChar(out, width));
}

std::string progressJson(const ProgressState& state) {
  io::JsonWriter out;
  out.open('{').field("type", "progress").key("task").raw(io::quoted(state.task, SIZE_MAX));
  if (state.fraction >= 0) out.field("fraction", state.fraction);
  for (const auto& [name, value] : state.numbers)
    if (std::isfinite(value)) out.field(name, value);
  if (knowsTime(state)) out.field("seconds left", state.secondsLeft);
  return out.finish();
}

Progress::Progress(ProgressMode mode, Console& console) : mode_(mode), console_(console) {}

Progress::~Progress() { hide(); }

void Progress::hide() {
  if (mode_ == ProgressMode::bar) console_.status("");
}

void Progress::update(const ProgressState& state) {
  if (mode_ == ProgressMode::none) return;
  const double now = watch_.seconds();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const bool firstAtOnce = !shown_ && mode_ != ProgressMode::line;
    if (!firstAtOnce && now - last_ < interval(mode_)) return;
    last_ = now;
    shown_ = true;
  }
  if (!io::takesMore(STDERR_FILENO, 0)) return;  // work never waits for a slow reader
  if (mode_ == ProgressMode::bar) {
    console_.status(progressLine(state, terminalWidth(STDERR_FILENO) - 1));
  } else if (mode_ == ProgressMode::json) {
    console_.line(progressJson(state));
  } else {
    console_.line(fmt::format("{:.0f} s  {}", now, progressLine(state, 200)));
  }
}

}  // namespace obby::cli
