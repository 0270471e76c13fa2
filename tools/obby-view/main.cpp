// obby-view: reads streams and writes a page or a text.
#include <optional>

#include "formats.h"
#include "live.h"
#include "options.h"
#include "output.h"
#include "reading.h"
#include "view/page.h"

namespace obby {
namespace {

Result<cli::ExitCode> run(cli::Context& context) {
  OBBY_RETURN_IF_ERROR(checkEnding(context.arguments()));
  OBBY_RETURN_IF_ERROR(refuseIdle(context.arguments()));
  if (wantedFormat(context.arguments()).page && !view::pageAvailable()) return view::pageMissing();
  if (context.arguments().flag("live")) return runLive(context);
  OBBY_ASSIGN(Output output, Output::open(context));
  const std::optional<view::Report> report = readReport(context);
  if (!report) return cli::ExitCode::failed;
  OBBY_RETURN_IF_ERROR(output.write(*report, context));
  return cli::ExitCode::ok;
}

}  // namespace
}  // namespace obby

int main(int argc, char** argv) {
  return obby::cli::runTool(obby::viewSpec(), argc, argv, obby::run);
}
