// obby-solve: answers the queries of a stream. Wiring only; lib/solve does the work.

#include "base/stopwatch.h"
#include "cli/context.h"
#include "cli/tool.h"
#include "io/sink.h"
#include "options.h"
#include "summary.h"
#include "terminal_table.h"
#include "watch.h"

namespace {

using namespace obby;

cli::ExitCode exitCode(const cli::Context& context, const solve::FilterCounts& counts) {
  if (!context.arguments().flag("exit-status")) return cli::ExitCode::ok;
  if (counts.unreachable > 0) return cli::ExitCode::noSolution;
  return counts.unknown > 0 ? cli::ExitCode::unknown : cli::ExitCode::ok;
}

// Reads one stream and writes one. The options keep the answers for the next run.
Status solveOnce(cli::Context& context, solve::FilterOptions& options,
                 const std::atomic<bool>& stop, tools::RunOutcome& outcome) {
  const Stopwatch watch;
  const auto table = tools::TerminalTable::wanted(context);
  OBBY_ASSIGN(io::StreamWriter output, table ? table->writer() : context.openOutput());
  io::SourceOptions source = context.sourceOptions();
  source.stop = &stop;
  io::Pipeline pipeline(std::move(source), context.identity(), std::move(output));
  solve::Filter filter(options, pipeline);
  Status status = pipeline.run([&](const io::Record& record) { return filter.handle(record); });
  // The rest of a stopped input is unknown, so missing queries are no error.
  if (status && !stop) status = filter.finishInput();
  // If the input itself failed, a missing query is not the user's mistake.
  if (!status && status.error().input.empty()) status = pipeline.source().lacking(status.error());
  status = pipeline.finish(std::move(status));
  if (table) OBBY_RETURN_IF_ERROR(table->print(context));
  if (options.remember) options.earlier = filter.takeEarlier();
  outcome = {filter.counts(), watch.seconds()};
  return status;
}

// Reports the outcome at the end. If a run fails before its first answer, only its error is shown.
void tellOutcome(cli::Context& context, const solve::FilterOptions& options, const Status& status,
                 const tools::RunOutcome& outcome) {
  const std::string text = tools::summary(options.task, outcome);
  if (status) {
    context.tell(context.stop() ? "interrupted: " + text : text);
  } else if (!io::isBrokenPipe(status.error()) && !outcome.isEmpty()) {
    context.tell("stopped by an error: " + text);
  }
}

Result<cli::ExitCode> run(cli::Context& context) {
  OBBY_ASSIGN(solve::FilterOptions options, tools::filterOptions(context));
  OBBY_ASSIGN(const sim::Backend backend, tools::searchBackend(context));
  options.device = backend.device();
  context.note(backend.note());
  tools::RunOutcome outcome;
  if (options.remember) {
    const tools::SolveOnce again = [&](solve::FilterOptions& o,
                                       const std::atomic<bool>& stop) -> Result<std::string> {
      OBBY_RETURN_IF_ERROR(solveOnce(context, o, stop, outcome));
      return tools::summary(o.task, outcome);
    };
    OBBY_RETURN_IF_ERROR(tools::watchInputs(context, options, again));
  } else {
    Status status = solveOnce(context, options, context.stop(), outcome);
    tellOutcome(context, options, status, outcome);
    OBBY_RETURN_IF_ERROR(std::move(status));
  }
  return exitCode(context, outcome.counts);
}

}  // namespace

int main(int argc, char** argv) {
  return obby::cli::runTool(obby::tools::solveSpec(), argc, argv, run);
}
