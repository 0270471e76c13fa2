// What learning leaves on disk to be used and to go on from: the policy and its checkpoint.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <span>

#include "cli/context.h"
#include "cli/written_files.h"
#include "io/output_file.h"
#include "start_policy.h"
#include "train/checkpoint.h"

namespace obby::tools {

class Keeper {
 public:
  // The first rank reads and writes for all. Every rank calls all of this. `late`: once it is set,
  // who takes nothing from a named pipe is given up, as io::Sink::open says; must outlive this.
  Keeper(const cli::Context& context, train::Ranks& ranks, const std::atomic<bool>& late);

  // Reads the policy of --start-from, and with --resume the checkpoint. Done before levels are
  // read, so that a wrong name is said at once. Errors: those of the files; standard output as a
  // file; files that could not be written later, or would be written over one another, or over what
  // is read; those that another run writes: as long as this lives they are this run's alone.
  Status find();
  // What is learned under, the levels' settings included, and on a device or not. Error: ranks that
  // differ in it.
  Status setRun(const train::TrainerSettings& trainer, const std::vector<train::Setting>& levels,
                bool onDevice);
  // One that goes on from what find() found, a new one that begins with the policy of --start-from,
  // or one with a fresh network. Errors: other settings than then, and those of Trainer.
  Result<std::unique_ptr<train::Trainer>> trainer(std::unique_ptr<train::Engine> engine);

  // Of the runs that this one goes on from.
  double secondsBefore() const { return secondsBefore_; }
  const train::History& historyBefore() const { return historyBefore_; }

  // The checkpoint first: killed between the two, the next run goes on from what is newer than the
  // policy, and writes the policy that belongs to it. Where it cannot be written, as on a full disk
  // of its own, the policy is written all the same. Before anything is learned nothing is written
  // where a policy or a checkpoint is there. `seconds`: of all runs.
  Status save(const train::Trainer& trainer, const train::History& history, double seconds) const;

 private:
  Status checkFiles();
  Status lockFiles(std::span<const cli::WrittenFile> written);
  Result<std::string> findBytes() const;
  std::string startName() const;
  Status savePolicy(const train::Trainer& trainer, const train::TrainerState& state,
                    double seconds) const;

  const cli::Context& context_;
  train::Ranks& ranks_;
  const std::atomic<bool>& late_;
  std::string checkpointPath_;  // empty: none is written
  io::OutputLocks locks_;       // the first rank's
  train::TrainerSettings settings_;
  std::vector<train::Setting> run_;
  std::optional<train::Checkpoint> found_;
  std::optional<StartPolicy> start_;
  std::string startName_;  // of the policy that all runs together began with, or kFresh
  double secondsBefore_ = 0;
  train::History historyBefore_;
};

}  // namespace obby::tools
