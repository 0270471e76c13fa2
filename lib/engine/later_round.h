// A second round of probes, late in the undisturbed run: parts and listeners that come later than
// the first round, and what waits for a time. Private to lib/engine.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "engine/child.h"
#include "engine/report.h"
#include "engine/stage.h"

namespace obby::engine {

class LaterRound {
 public:
  LaterRound(Stage& stage, const Plan& plan, Children& children, Report& report);

  // Parts made since the first round join report.made. Targets that are new join report.probes;
  // some of the others are probed once more, and what differs joins report.revisits.
  void look();
  // At the end of the run: drops the made parts that have gone since look().
  void dropGone();

 private:
  void addMade();
  void split();
  void probeNew();
  void probeAgain();
  bool compare(const Probe& again);

  Stage& stage_;
  const Plan& plan_;
  Children& children_;
  Report& report_;
  std::map<InstanceId, size_t> first_;       // index into report.probes, by target
  std::vector<Probe> fresh_, again_, rest_;  // rest_: of the first round, beyond again_
  std::set<std::string> usualFirst_, usualNow_;
};

}  // namespace obby::engine
