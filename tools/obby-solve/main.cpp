// obby-solve: answers the queries of a stream. Wiring only; lib/solve does the work.
#include <fmt/format.h>

#include "cli/context.h"
#include "cli/tool.h"
#include "options.h"
#include "terminal_table.h"
#include "watch.h"

namespace {

using namespace obby;

cli::ExitCode exitCode(const cli::Context& context, const solve::FilterCounts& counts) {
  if (!context.arguments().flag("exit-status")) return cli::ExitCode::ok;
  if (counts.unreachable > 0) return cli::ExitCode::noSolution;
  return counts.unknown > 0 ? cli::ExitCode::unknown : cli::ExitCode::ok;
}

std::string summary(solve::Task task, const solve::FilterCounts& counts) {
  switch (task) {
    case solve::Task::verify:
      return fmt::format("{} trajectories replayed as recorded", counts.verified);
    case solve::Task::filter:
      return fmt::format("{} of {} trajectories kept", counts.kept, counts.kept + counts.dropped);
    case solve::Task::answer: break;
  }
  return fmt::format("{} solved, {} unreachable, {} unknown", counts.solved, counts.unreachable,
                     counts.unknown);
}

// One stream in, one stream out. The options keep the answers for the next run.
Status solveOnce(cli::Context& context, solve::FilterOptions& options,
                 const std::atomic<bool>& stop, solve::FilterCounts& counts) {
  const auto table = tools::TerminalTable::wanted(context);
  OBBY_ASSIGN(io::StreamWriter output, table ? table->writer() : context.openOutput());
  io::SourceOptions source = context.sourceOptions();
  source.stop = &stop;
  io::Pipeline pipeline(std::move(source), context.identity(), std::move(output));
  solve::Filter filter(options, pipeline);
  Status status = pipeline.run([&](const io::Record& record) { return filter.handle(record); });
  // Of a stopped input nobody knows what would have come.
  if (status && !stop) status = filter.finishInput();
  status = pipeline.finish(std::move(status));
  if (table) OBBY_RETURN_IF_ERROR(table->print(context));
  if (options.remember) options.earlier = filter.takeEarlier();
  OBBY_RETURN_IF_ERROR(std::move(status));
  counts = filter.counts();
  context.note(summary(options.task, counts));
  return {};
}

Result<cli::ExitCode> run(cli::Context& context) {
  OBBY_ASSIGN(solve::FilterOptions options, tools::filterOptions(context));
  OBBY_ASSIGN(const sim::Backend backend, tools::searchBackend(context));
  options.device = backend.device();
  context.note(backend.note());
  solve::FilterCounts counts;
  if (options.remember) {
    OBBY_RETURN_IF_ERROR(tools::watchInputs(
        context, options, [&](solve::FilterOptions& o, const std::atomic<bool>& stop) {
          return solveOnce(context, o, stop, counts);
        }));
  } else {
    OBBY_RETURN_IF_ERROR(solveOnce(context, options, context.stop(), counts));
  }
  return exitCode(context, counts);
}

}  // namespace

int main(int argc, char** argv) {
  return obby::cli::runTool(obby::tools::solveSpec(), argc, argv, run);
}
