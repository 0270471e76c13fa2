// Recordings of the calibration course by our own simulator, under parameters that the fit does not
// know.
#pragma once

#include "calibrate/course_level.h"
#include "calibrate/manoeuvres.h"
#include "calibrate/objective.h"

namespace obby::calibrate {

inline schema::PhysicsParams::Reader defaults() {
  static io::RecordBuilder record;
  return record.root().initParams().asReader();
}

// Of the first `count` manoeuvres. The levels of the takes do not say the parameters.
inline std::vector<Take> takesUnder(schema::PhysicsParams::Reader params, float noise = 0,
                                    size_t count = SIZE_MAX) {
  io::RecordBuilder plain, hidden;
  writeCourse(plain.root().initLevel());
  writeCourse(hidden.root().initLevel());
  hidden.root().getLevel().setPhysics(params);
  const auto level = level::Level::compile(hidden.reader().getLevel());
  const io::Record record(std::move(plain));
  std::vector<Take> out;
  for (const Manoeuvre& m : manoeuvres()) {
    if (out.size() == count) break;
    out.push_back({rehearse(*level, m, noise, out.size()), record});
  }
  return out;
}

}  // namespace obby::calibrate
