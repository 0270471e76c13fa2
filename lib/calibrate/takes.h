// Collects recordings and their levels from a stream.
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
  // Handles a record of the pipeline: keeps levels and recordings and passes on the rest. Errors: a
  // recording whose level has not come before it, and those of trackOf() and Level::compile.
  Result<io::Then> handle(const io::Record& record);

  // Returns the takes in the order of arrival. Names are unique, so that reports are unambiguous.
  std::vector<Take> take() { return std::move(takes_); }

  // Returns a warning for each moving part that does not follow its level's motion. A player on
  // that part is compared with a wrong floor, which biases the parameters.
  std::vector<std::string> warnings() const;

 private:
  Status add(schema::Recording::Reader recording);
  std::string unlike(const std::string& name);
  void lookForStrays(const Track& track, const level::Level& level);

  // A part's deviations in all recordings of its level, and the largest of them.
  struct Astray {
    uint32_t recordings = 0;
    float studs = 0;
    std::string part, recording;
  };
  std::map<std::pair<std::string, uint32_t>, Astray> astray_;  // by level and number
  std::set<std::string> names_;
  std::map<std::string, uint32_t> numbers_;  // recordings per original name
  std::map<std::string, io::Record> levels_;
  std::vector<Take> takes_;
};

// Moves every n-th take, beginning with the n-th, out of `takes`.
std::vector<Take> holdOut(std::vector<Take>& takes, uint32_t n);

}  // namespace obby::calibrate
