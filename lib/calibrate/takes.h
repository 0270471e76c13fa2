// Recordings with their levels, out of a stream.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "calibrate/objective.h"
#include "io/pipeline.h"

namespace obby::calibrate {

class Takes {
 public:
  // The pipeline's handler: keeps levels and recordings, passes the rest. Errors: a recording
  // whose level did not come before it, those of trackOf() and of Level::compile.
  Result<io::Then> handle(const io::Record& record);

  // In the order in which they came. No two have one name: what is said of a recording is said of
  // one.
  std::vector<Take> take() { return std::move(takes_); }

  // Moving parts that do not move as their level says: whoever rides one is played beside where
  // they were, and parameters bend to make up for it.
  std::vector<std::string> warnings() const;

 private:
  Status add(schema::Recording::Reader recording);
  std::string unlike(const std::string& name);
  void lookForStrays(const Track& track, const level::Level& level);

  // A part in all recordings of its level, and the worst of these.
  struct Astray {
    uint32_t recordings = 0;
    float studs = 0;
    std::string part, recording;
  };
  std::map<std::pair<std::string, uint32_t>, Astray> astray_;  // by level and number
  std::set<std::string> names_;
  std::map<std::string, uint32_t> numbers_;  // of recordings that were given a name
  std::map<std::string, io::Record> levels_;
  std::vector<Take> takes_;
};

// Every n-th, beginning with the n-th, goes to `heldOut`.
std::vector<Take> holdOut(std::vector<Take>& takes, uint32_t n);

}  // namespace obby::calibrate
