// Runs a second round of probes, late in the undisturbed run. It finds parts and listeners that
// appear after the first round, and effects that wait for a time. Private to lib/engine.
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

  // Adds parts made since the first round to report.made, and probes of new targets to
  // report.probes. Probes some of the other targets once more and adds differences to
  // report.revisits.
  void look();
  // Drops the made parts that have vanished since look(). Call it at the end of the run.
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
  std::vector<Probe> fresh_, again_, rest_;  // rest_: targets of the first round not in again_
  std::set<std::string> usualFirst_, usualNow_;
};

}  // namespace obby::engine
