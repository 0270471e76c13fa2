// A training run: iterations until a limit, with saves, metrics and logs between them.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "base/stopwatch.h"
#include "train/ranks.h"
#include "train/run/checkpoint_store.h"
#include "train/run/event_log.h"
#include "train/run/metrics_stream.h"
#include "train/run/streamed_levels.h"
#include "train/trainer.h"

namespace obby::train {

struct RunLimits {
  uint64_t decisions = 0;     // max decisions of all runs together
  double seconds = 0;         // max wall-clock time of this run
  double saveSeconds = 60;    // seconds between saves
  uint64_t eventsEvery = 10;  // iterations between two events of the log
};

struct RunProgress {
  double share = 0;        // share of the decisions or of the time, whichever is larger; 0 to 1
  double secondsLeft = 0;  // estimate
  double decisionsPerSecond = 0;
  double solved = 0, hardest = 0;  // as in Iteration
};

// Callbacks through which a run reports to its user.
struct RunReport {
  std::function<void(const std::string&)> warn, note;
  std::function<void(const RunProgress&)> progress;
};

// Outputs of the first rank; other ranks have none.
struct RunOutputs {
  MetricsStream* metrics = nullptr;
  EventLog* events = nullptr;  // may be null
};

class TrainingRun {
 public:
  // The arguments must outlive the run.
  TrainingRun(Trainer& trainer, Ranks& ranks, const CheckpointStore& store, RunLimits limits,
              RunOutputs outputs, const RunReport& report, Timeout& timeout);

  // Trains until a limit, a signal (Timeout::stop) or an error, and saves. If training itself
  // fails, nothing more can be saved. The first save must succeed. Later saves and events that
  // cannot be written cause a warning, and training continues; it is an error if writing still
  // fails at the end.
  Status run();

 private:
  struct Votes {  // the ranks' common decision
    bool stop, save;
  };
  struct Mark {
    double seconds;
    uint64_t decisions;
  };
  double seconds() const { return watch_.seconds(); }  // wall-clock time of this run
  double allSeconds() const { return store_.secondsBefore() + seconds(); }
  double meanRate() const;  // decisions per second, in this run
  double presentRate();     // decisions per second, over the last five to ten seconds
  Votes vote();
  Status report();
  void reportProgress();
  void reportHeldEvents();
  Status writeMetrics();
  Status save();
  Status saveMeanwhile();
  Status saveAfter(Status ended);

  Trainer& trainer_;
  Ranks& ranks_;
  const CheckpointStore& store_;
  const RunLimits limits_;
  const RunOutputs outputs_;
  const RunReport& report_;
  Timeout& timeout_;
  const uint64_t decisionsBefore_;
  Iteration last_;
  const Stopwatch watch_;
  double metricsAt_ = 0, savedAt_ = 0;    // seconds of this run
  uint64_t metricsOf_ = 0;                // iteration of the last record
  bool saved_ = false, failing_ = false;  // a save succeeded before the end; the last one failed
  bool eventsHeld_ = false;               // the user knows that events wait
  Mark pace_[2];                          // an older and a newer mark, for presentRate()
};

struct RunPlan {
  RunLimits limits;
  std::string eventFolder;  // folder of the events for TensorBoard; may be empty
  io::StreamIdentity identity;
};

// Opens the outputs of the first rank, with metrics on standard output, and runs the training. The
// end record includes the counts of `levels`. `stop` is set by a signal.
Status runTraining(Trainer& trainer, Ranks& ranks, const CheckpointStore& store,
                   const Levels& levels, const RunPlan& plan, const RunReport& report,
                   const std::atomic<bool>& stop, Timeout& timeout);

}  // namespace obby::train
