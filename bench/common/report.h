// Output of all benches: aligned rows, or with --json one object per line:
//   {"bench":"search","case":"parts100","metric":"stepsPerSecond","value":5.1e6,"unit":"1/s"}
// Rows are written at once, so that a long bench shows its progress.
#pragma once

#include <string>
#include <string_view>

#include "base/stopwatch.h"

namespace obby::bench {

class Report {
 public:
  // `bench` is the program's name without its prefix. The only option is --json. Any other argument
  // prints the usage and exits with 2.
  Report(int argc, char** argv, std::string bench);

  enum class Form { table, json };
  // Makes a report for a bench that parses its own options.
  Report(std::string bench, Form form);

  // Adds a measurement. `metric` in camelCase, `unit` as printed ("1/s", "ns", "" for a ratio).
  void add(std::string_view caseName, std::string_view metric, double value, std::string_view unit);

 private:
  std::string bench_;
  bool json_ = false;
  bool headed_ = false;
};

// Returns the wall-clock seconds of `work()`.
template <class Work>
double secondsOf(Work&& work) {
  const Stopwatch watch;
  work();
  return watch.seconds();
}

// Returns the CPU seconds of the calling thread, which do not depend on other load.
double threadSeconds();

template <class Work>
double cpuSecondsOf(Work&& work) {
  const double start = threadSeconds();
  work();
  return threadSeconds() - start;
}

}  // namespace obby::bench
