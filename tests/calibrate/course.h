// Recordings of the calibration course, made by our own simulator under parameters that the fit
// must find.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "base/random.h"
#include "calibrate/course_level.h"
#include "calibrate/manoeuvres.h"
#include "calibrate/objective.h"
#include "calibrate/work.h"

namespace obby::calibrate {

inline schema::PhysicsParams::Reader defaults() {
  static io::RecordBuilder record;
  return record.root().initParams().asReader();
}

// Draws every parameter that can be fitted within a share of its default, well within the fit's
// bounds. A parameter that is 0 stays 0.
inline io::RecordBuilder drawnParams(uint64_t seed, double spread) {
  io::RecordBuilder out;
  auto params = out.root().initParams();
  Random random(seed, 0x9a3d);
  for (const Parameter& p : parametersAround(defaults())) {
    if (valueOf(defaults(), p.name) <= 0) continue;
    const double value =
        valueOf(defaults(), p.name) * (1 + spread * (2 * double(random.unit()) - 1));
    setValue(params, p.name, std::clamp(value, valueAt(p, 0.05), valueAt(p, 0.95)));
  }
  return out;
}

// A context for fits that run to the end and show no progress.
struct Undisturbed {
  ThreadPool pool{availableThreads()};
  const std::atomic<bool> stop{false};
  Account account{[](const FitProgress&) {}};
  const Work work{pool, stop, account};
};

inline std::vector<Manoeuvre> firstManoeuvres(size_t count) {
  std::vector<Manoeuvre> out = manoeuvres();
  out.resize(count);
  return out;
}

// Returns the manoeuvres with these names. A fit takes longer with more recordings, so each test
// plays only those it needs.
inline std::vector<Manoeuvre> manoeuvresNamed(const std::vector<std::string>& names) {
  std::vector<Manoeuvre> out;
  for (const Manoeuvre& m : manoeuvres()) {
    if (std::find(names.begin(), names.end(), m.name) != names.end()) out.push_back(m);
  }
  return out;
}

// Returns recordings of the simulator under these parameters. The levels of the takes do not state
// the parameters.
inline std::vector<Take> takesUnder(schema::PhysicsParams::Reader params, float noise = 0,
                                    const std::vector<Manoeuvre>& played = manoeuvres()) {
  io::RecordBuilder plain, hidden;
  writeCourse(plain.root().initLevel());
  writeCourse(hidden.root().initLevel());
  hidden.root().getLevel().setPhysics(params);
  const auto level = level::Level::compile(hidden.reader().getLevel());
  const io::Record record(std::move(plain));
  std::vector<Take> out;
  for (const Manoeuvre& m : played) out.push_back({rehearse(*level, m, noise, out.size()), record});
  return out;
}

}  // namespace obby::calibrate
