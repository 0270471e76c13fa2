// A run of learning: iterations until enough, and what is told and kept on the way.
#pragma once

#include <chrono>

#include "cli/context.h"
#include "keeper.h"
#include "logs.h"
#include "metrics_stream.h"
#include "train/wait_limit.h"

namespace obby::tools {

class Session {
 public:
  // What it refers to must outlive it. `output`: null on all ranks but the first, which alone tells
  // and keeps anything. `waiting`: for levels; begins with it.
  Session(cli::Context& context, train::Trainer& trainer, train::Ranks& ranks, const Keeper& keeper,
          Logs logs, MetricsStream* output, train::WaitLimit& waiting);

  // Until --decisions, --time-limit (of this run), a signal, or an error. Saves in the end but
  // where the error is that nothing can be learned any more. Of the saves before only the first has
  // to succeed: of later ones that fail it is told, and learning goes on. So it does where a log
  // cannot be written; rows that are missing in the end are an error.
  Status run();

 private:
  double seconds() const;  // of this run
  double allSeconds() const { return keeper_.secondsBefore() + seconds(); }
  double rate() const;   // decisions a second, of this run
  double presentRate();  // of its last seconds
  void showProgress();
  struct Votes {  // of all ranks
    bool stop, save;
  };
  struct Mark {
    double seconds;
    uint64_t decisions;
  };
  Votes vote();
  Status note();
  void showHeldLogs();
  Status tell();
  Status save();
  Status saveMeanwhile();
  Status saveAfter(Status ended);

  cli::Context& context_;
  train::Trainer& trainer_;
  train::Ranks& ranks_;
  const Keeper& keeper_;
  Logs logs_;
  MetricsStream* output_;
  train::WaitLimit& waiting_;
  uint64_t decisionsBefore_, most_;
  double mostSeconds_, saveSeconds_;
  train::Iteration last_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double toldAt_ = 0, savedAt_ = 0;
  uint64_t told_ = 0;                     // number of the iteration of the last record
  bool saved_ = false, failing_ = false;  // a save before the end; the last of these
  bool logsHeld_ = false;                 // that rows of logs wait is told
  Mark pace_[2];                          // of progress: an older one, a newer one
};

}  // namespace obby::tools
