#include "watch.h"

#include <fmt/format.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "io/file_watch.h"
#include "io/sink.h"
#include "verdict_changes.h"

namespace obby::tools {

namespace {

constexpr std::chrono::milliseconds kPoll{50};

// Inputs must be files other than the output, or each answer would trigger another run.
Status canWatch(const cli::Context& context) {
  for (const std::string& path : context.inputs()) {
    if (path == "-") {
      return Error{
          {}, {}, "--watch", "cannot watch standard input", "give the input files by name"};
    }
  }
  return context.checkOutput();
}

std::string quotedNames(const std::vector<std::string>& paths) {
  return fmt::format("'{}'", fmt::join(paths, "', '"));
}

// Sets `stop` once the inputs change or the process is asked to end, since the current answer is
// then outdated.
class Guard {
 public:
  Guard(const io::FileWatch& files, const std::atomic<bool>& end, std::atomic<bool>& stop)
      : thread_([&files, &end, &stop](const std::stop_token& done) {
          while (!done.stop_requested()) {
            if (end || files.changed()) stop = true;
            std::this_thread::sleep_for(kPoll);
          }
        }) {}

 private:
  std::jthread thread_;
};

// The input files, and those that changed since the last complete run.
class Inputs {
 public:
  explicit Inputs(const std::vector<std::string>& paths) : paths_(paths), all_(paths) {
    noteEach();
  }

  const io::FileWatch& all() const { return all_; }

  // Call it before a run; see FileWatch::settle.
  void settle(const std::atomic<bool>& stop) {
    for (size_t i = 0; i < paths_.size(); ++i) changed_[i] = changed_[i] || each_[i].changed();
    all_.settle(stop);
    noteEach();
  }

  // Returns names such as "'level.jsonl'", or an empty text, and clears them.
  std::string takeChanged() {
    std::vector<std::string> names;
    for (size_t i = 0; i < paths_.size(); ++i) {
      if (changed_[i]) names.push_back(paths_[i]);
    }
    changed_.assign(paths_.size(), false);
    return names.empty() ? "" : quotedNames(names);
  }

 private:
  void noteEach() {
    each_.clear();
    for (const std::string& path : paths_) each_.emplace_back(std::vector{path});
    changed_.resize(paths_.size());
  }

  const std::vector<std::string> paths_;
  io::FileWatch all_;
  std::vector<io::FileWatch> each_;  // (paths)
  std::vector<bool> changed_;        // (paths)
};

class Watch {
 public:
  Watch(cli::Context& context, solve::FilterOptions& options, const SolveOnce& solve)
      : context_(context), options_(options), solve_(solve), inputs_(context.inputs()) {
    options_.answered = [this](const std::string& level, const std::string& query,
                               schema::Verdict verdict) { verdicts_.note(level, query, verdict); };
  }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;
  ~Watch() { options_.answered = {}; }

  Status run() {
    while (!context_.stop()) {
      inputs_.settle(context_.stop());
      OBBY_RETURN_IF_ERROR(runOnce());
      while (!context_.stop() && !inputs_.all().changed()) std::this_thread::sleep_for(kPoll);
    }
    return {};
  }

 private:
  Status runOnce() {
    std::atomic<bool> stop{context_.stop().load()};
    const Guard guard(inputs_.all(), context_.stop(), stop);
    options_.solver.budget.stop = &stop;
    const Result<std::string> outcome = solve_(options_, stop);
    if (!outcome && io::isBrokenPipe(outcome.error()))
      return outcome.error();  // the output has no reader
    // An error in a file is reported; the next edit may fix it.
    if (!outcome) context_.warn(outcome.error().text());
    if (outcome && !stop) {
      tell(*outcome);
    } else {
      verdicts_.drop();
    }
    sayWhatFor();
    return {};
  }

  void tell(const std::string& outcome) {
    const std::string changed = inputs_.takeChanged(), verdicts = verdicts_.finish();
    context_.tell(changed.empty() ? outcome
                                  : fmt::format("{} changed: {} ({})", changed, outcome, verdicts));
  }

  // Announces the watch once, after the first run.
  void sayWhatFor() {
    if (said_ || context_.stop()) return;
    context_.tell(fmt::format("watching {}; press Ctrl-C to stop", quotedNames(context_.inputs())));
    said_ = true;
  }

  cli::Context& context_;
  solve::FilterOptions& options_;
  const SolveOnce& solve_;
  Inputs inputs_;
  VerdictChanges verdicts_;
  bool said_ = false;
};

}  // namespace

Status watchInputs(cli::Context& context, solve::FilterOptions& options, const SolveOnce& solve) {
  OBBY_RETURN_IF_ERROR(canWatch(context));
  return Watch(context, options, solve).run();
}

}  // namespace obby::tools
