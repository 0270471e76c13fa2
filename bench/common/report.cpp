// The two forms of a measurement, table row and JSON line.
#include "common/report.h"

#include <time.h>

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include "io/json_writer.h"

namespace obby::bench {
namespace {

void writeLine(std::string line) {
  line += '\n';
  const bool written = std::fwrite(line.data(), 1, line.size(), stdout) == line.size();
  if (!written || std::fflush(stdout) != 0) {
    std::perror("bench: stdout");
    std::exit(2);
  }
}

// Formats three or four significant digits with a decimal prefix: 5123456 is "5.123 M".
std::string forPeople(double value) {
  const double size = std::fabs(value);
  if (size >= 1e9) return fmt::format("{:.4g} G", value / 1e9);
  if (size >= 1e6) return fmt::format("{:.4g} M", value / 1e6);
  if (size >= 1e4) return fmt::format("{:.4g} k", value / 1e3);
  return fmt::format("{:.4g}  ", value);
}

}  // namespace

Report::Report(int argc, char** argv, std::string bench) : bench_(std::move(bench)) {
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]) == "--json") {
      json_ = true;
    } else {
      fmt::print(stderr, "bench_{}: unknown argument {}\nusage: bench_{} [--json]\n", bench_,
                 argv[i], bench_);
      std::exit(2);
    }
  }
}

Report::Report(std::string bench, Form form)
    : bench_(std::move(bench)), json_(form == Form::json) {}

void Report::add(std::string_view caseName, std::string_view metric, double value,
                 std::string_view unit) {
  if (json_) {
    // A measurement that is not finite has failed, and is null.
    io::JsonWriter json;
    json.open('{').field("bench", bench_).field("case", caseName).field("metric", metric);
    writeLine(json.field("value", value).field("unit", unit).finish());
    return;
  }
  constexpr std::string_view kRow = "{:<10} {:<24} {:<28} {:>12} {}";
  if (!headed_) writeLine(fmt::format(kRow, "bench", "case", "metric", "value  ", "unit"));
  headed_ = true;
  writeLine(fmt::format(kRow, bench_, caseName, metric, forPeople(value), unit));
}

double threadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + double(now.tv_nsec) * 1e-9;
}

}  // namespace obby::bench
