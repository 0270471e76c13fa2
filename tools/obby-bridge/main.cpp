// obby-bridge: lets editors run searches and calibrations. Wiring only; lib/bridge does the work.
#include "cli/context.h"
#include "cli/tool.h"
#include "options.h"

namespace {

using namespace obby;

Result<cli::ExitCode> run(cli::Context& context) {
  OBBY_ASSIGN(const bridge::Options options, tools::bridgeOptions(context));
  OBBY_ASSIGN(io::Sink output, io::Sink::open("-", io::Durable::no, &context.stop()));
  bridge::Reports reports;
  reports.warn = [&](const std::string& text) { context.warn(text); };
  reports.note = [&](const std::string& text) { context.note(text); };
  if (context.arguments().flag("stdio")) {
    OBBY_RETURN_IF_ERROR(bridge::serveStdio(options, context.stop(), reports, std::move(output)));
    return cli::ExitCode::ok;
  }
  // The server keeps running if standard output is closed.
  reports.say = [&](const std::string& text) {
    if (!output.write(text + "\n") || !output.flush()) context.note("standard output is closed");
  };
  OBBY_RETURN_IF_ERROR(bridge::serveHttp(options, context.stop(), reports));
  return cli::ExitCode::ok;
}

}  // namespace

int main(int argc, char** argv) {
  return obby::cli::runTool(obby::tools::bridgeSpec(), argc, argv, run);
}
