// The clocks of a level while its parts are compiled: each part's own, and shared ones, which are
// found by the names of signals.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "level/level_view.h"
#include "schema/obby.capnp.h"

namespace obby::level {

// Placeholder for a part's own clock until its role has a number.
constexpr uint32_t kOwnClock = 0xfffffffeu;

class ClockTables {
 public:
  // Adds the signals that buttons start. Must be called before signal() and button().
  Status addSignals(schema::Level::Reader level, const Params& params);

  // Returns the clock of a signal for a part that responds. An error has the path of the field that
  // names the signal.
  Result<uint32_t> signal(const std::string& name, const std::string& path);

  // Returns the clock of a button that addSignals() added.
  uint32_t button(const std::string& name) const;

  uint32_t add(const Clock& clock);  // always adds a new clock
  // Returns the clock of an earlier share() with the same effect, or adds a new one.
  uint32_t share(const Clock& clock);

  // Returns an error unless every signal is named by a part that responds to it.
  Status checkSignals() const;

  // Returns the table: each role's clock, then the others. Sets their final numbers in roles and
  // movers.
  std::vector<Clock> finish(const std::vector<Clock>& own, const std::vector<Collider>& colliders,
                            std::vector<Roles>& roles, std::vector<Mover>& movers) const;

 private:
  struct Signal {
    uint32_t clock;
    size_t part;  // first part whose button starts the signal
    bool used = false;
  };
  Status addButton(schema::Part::Reader part, size_t index, const Params& params);

  std::map<std::string, Signal> signals_;
  std::vector<Clock> shared_;
  std::map<uint64_t, uint32_t> given_;  // clocks from share(), by digest
};

// Returns the digest of everything that a clock does, continued from `seed` (hashBytes). Clocks
// with equal digests are interchangeable. A later field counts only if it has an effect, so that
// the digests of older levels do not change.
uint64_t digestOf(const Clock& clock, uint64_t seed = 0);

// Converts seconds to ticks. A negative number or NaN is an error at `path`.
Result<uint32_t> ticksOf(const Params& params, float seconds, const std::string& path);

}  // namespace obby::level
