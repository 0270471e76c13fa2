// obby-solve: answers the queries of a stream. Wiring only; lib/solve does the work.
#include <fmt/format.h>

#include "cli/context.h"
#include "cli/tool.h"
#include "options.h"

namespace {

using namespace obby;

cli::ExitCode exitCode(const cli::Context& context, const solve::FilterCounts& counts) {
  if (!context.arguments().flag("exit-status")) return cli::ExitCode::ok;
  if (counts.unreachable > 0) return cli::ExitCode::noSolution;
  return counts.unknown > 0 ? cli::ExitCode::unknown : cli::ExitCode::ok;
}

Result<cli::ExitCode> run(cli::Context& context) {
  OBBY_ASSIGN(solve::FilterOptions options, tools::filterOptions(context));
  OBBY_ASSIGN(const sim::Backend backend, tools::searchBackend(context));
  options.device = backend.device();
  context.note(backend.note());
  OBBY_ASSIGN(io::StreamWriter output, context.openOutput());
  const bool verifyOnly = options.verifyOnly;
  io::Pipeline pipeline(context.sourceOptions(), context.identity(), std::move(output));
  solve::Filter filter(std::move(options), pipeline);
  Status status = pipeline.run([&](const io::Record& record) { return filter.handle(record); });
  if (status) status = filter.finishInput();
  const Status finished = pipeline.finish();
  OBBY_RETURN_IF_ERROR(std::move(status));
  OBBY_RETURN_IF_ERROR(finished);
  const solve::FilterCounts& c = filter.counts();
  context.note(verifyOnly ? fmt::format("{} trajectories replayed as recorded", c.verified)
                          : fmt::format("{} solved, {} unreachable, {} unknown", c.solved,
                                        c.unreachable, c.unknown));
  return exitCode(context, c);
}

}  // namespace

int main(int argc, char** argv) {
  return obby::cli::runTool(obby::tools::solveSpec(), argc, argv, run);
}
