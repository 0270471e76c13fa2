// The clocks of a level while its parts are compiled: each part's own, and those that parts share,
// found by the names of signals.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "base/result.h"
#include "level/level_view.h"
#include "schema/obby.capnp.h"

namespace obby::level {

// Stands for a part's own clock until its role has a number.
constexpr uint32_t kOwnClock = 0xfffffffeu;

class ClockTables {
 public:
  // The signals that buttons start; before any part asks for one.
  Status addSignals(schema::Level::Reader level, const Params& params);

  // The clock of a signal, for a part that responds; the error has the path of the field that names
  // it.
  Result<uint32_t> signal(const std::string& name, const std::string& path);

  uint32_t button(const std::string& name) const;  // the same, of a button that was added

  uint32_t add(const Clock& clock);    // of its own
  uint32_t share(const Clock& clock);  // the one that does the same, where there is one

  // Every signal must be named by a part that responds to it.
  Status checkSignals() const;

  // The table: each role's clock, then the others. Names them so in roles and movers.
  std::vector<Clock> finish(const std::vector<Clock>& own, const std::vector<Collider>& colliders,
                            std::vector<Roles>& roles, std::vector<Mover>& movers) const;

 private:
  struct Signal {
    uint32_t clock;
    size_t part;  // of the first button
    bool used = false;
  };
  Status addButton(schema::Part::Reader part, size_t index, const Params& params);

  std::map<std::string, Signal> signals_;
  std::vector<Clock> shared_;
  using Effect = std::tuple<uint32_t, bool, float, float, float, float, bool, uint32_t, uint32_t>;
  std::map<Effect, uint32_t> given_;  // by share(): what does the same has one clock
};

// Ticks of a duration; refuses what is negative or no number.
Result<uint32_t> ticksOf(const Params& params, float seconds, const std::string& path);

}  // namespace obby::level
