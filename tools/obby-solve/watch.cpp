#include "watch.h"

#include <chrono>
#include <thread>

#include "io/file_watch.h"
#include "io/sink.h"

namespace obby::tools {

namespace {

constexpr std::chrono::milliseconds kPoll{50};

// Files, and others than what is written: that would be a change, to be answered for ever.
Status canWatch(const cli::Context& context) {
  for (const std::string& path : context.inputs()) {
    if (path == "-") return Error{{}, {}, "--watch", "needs files, not standard input", {}};
  }
  return context.checkOutput();
}

// Sets `stop` once the inputs change or the process is to end: an answer to what is no longer asked
// is not worth waiting for.
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

}  // namespace

Status watchInputs(cli::Context& context, solve::FilterOptions& options, const SolveOnce& solve) {
  OBBY_RETURN_IF_ERROR(canWatch(context));
  io::FileWatch files(context.inputs());
  while (!context.stop()) {
    files.settle(context.stop());
    std::atomic<bool> stop{context.stop().load()};
    {
      const Guard guard(files, context.stop(), stop);
      options.solver.budget.stop = &stop;
      const Status status = solve(options, stop);
      if (!status && io::isBrokenPipe(status.error())) return status.error();  // who would read on?
      // A mistake in a file is told, and may be mended by the next change.
      if (!status) context.warn(status.error().text());
    }
    while (!context.stop() && !files.changed()) std::this_thread::sleep_for(kPoll);
  }
  return {};
}

}  // namespace obby::tools
