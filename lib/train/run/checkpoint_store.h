// The files that a training run leaves: the policy, and the checkpoint from which to resume.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/output_file.h"
#include "io/pipeline.h"
#include "train/checkpoint.h"
#include "train/run/start_policy.h"
#include "train/trainer.h"

namespace obby::train {

enum class Resume { no, yes, automatic };  // automatic: start a new run if there is no checkpoint

struct RunFiles {
  std::string policy;      // --output
  std::string checkpoint;  // --checkpoint; empty: none is written
  std::string startFrom;   // --start-from; empty: a fresh network
  Resume resume = Resume::no;
};

// Describes how the run was started, for its files.
struct RunIdentity {
  std::string command;
  io::StreamIdentity stream;
};

// Returns the checkpoint's default path, next to the policy, or an empty path if the policy goes to
// a device or a pipe.
std::string defaultCheckpoint(const std::string& policy);

class CheckpointStore {
 public:
  // The first rank reads and writes for all; every rank calls the same functions. `stop` ends
  // reading; `late` gives up the reader of a named pipe, as in io::Sink::open. The references must
  // outlive this object.
  CheckpointStore(RunFiles files, RunIdentity identity, Ranks& ranks, const std::atomic<bool>& stop,
                  const std::atomic<bool>& late);

  // Locks the files for the life of this object, and reads the policy to start from and the
  // checkpoint to resume from. Call it before levels are read, so that a mistyped name is reported
  // at once. Errors: files that cannot be read, cannot be written later, or are locked by another
  // run.
  Status open();
  // Sets the settings of the run, including those of the levels. Error: ranks with other settings.
  Status setRun(const TrainerSettings& trainer, const std::vector<Setting>& levels, bool onDevice);
  // Returns a trainer that resumes from the checkpoint that open() found, or starts from the policy
  // of --start-from or a fresh network. Errors: other settings than the checkpoint's, and those of
  // Trainer.
  Result<std::unique_ptr<Trainer>> trainer(std::unique_ptr<Engine> engine);

  // Returns the wall-clock time of the runs before this one.
  double secondsBefore() const { return secondsBefore_; }

  // Writes the checkpoint, then the policy. If training is killed between the two, the next run
  // resumes from the newer checkpoint and writes the policy again. If the checkpoint cannot be
  // written, the policy is written nevertheless. Until training has learned from a decision,
  // existing files are kept. `seconds`: wall-clock time of all runs.
  Status save(const Trainer& trainer, double seconds) const;

 private:
  Status lockAndCheckFiles();
  Result<std::string> checkpointBytes() const;
  std::string startName() const;
  Status savePolicy(const Trainer& trainer, const TrainerState& state, double seconds) const;

  RunFiles files_;
  RunIdentity identity_;
  Ranks& ranks_;
  const std::atomic<bool>& stop_;
  const std::atomic<bool>& late_;
  io::OutputLocks locks_;  // the first rank's
  TrainerSettings settings_;
  std::vector<Setting> run_;
  std::optional<Checkpoint> found_;
  std::optional<StartPolicy> start_;
  std::string startName_;  // name of the policy that the first run started from, or kFresh
  double secondsBefore_ = 0;
};

}  // namespace obby::train
