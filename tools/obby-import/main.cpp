// obby-import: place and model files to levels and queries. Wiring only; lib/import does the work.
#include "cli/context.h"
#include "cli/tool.h"
#include "import/filter.h"
#include "io/physics.h"
#include "io/pipeline.h"
#include "options.h"

namespace {

using namespace obby;

Result<cli::ExitCode> explain(cli::Context& context, importer::ImportOptions options) {
  OBBY_ASSIGN(io::Sink sink, context.openSink());
  options.explain = true;
  std::string table;
  importer::InputOpener opener(
      options, [&](const std::string& warning) { context.note(warning); },
      [&](const std::string& text) { table += (table.empty() ? "" : "\n") + text; },
      &context.stop());
  for (const std::string& path : context.inputs()) {
    auto opened = opener.open(path);
    if (!opened) return opened.error();
  }
  OBBY_RETURN_IF_ERROR(sink.write(table));
  OBBY_RETURN_IF_ERROR(sink.close());
  return cli::ExitCode::ok;
}

Result<cli::ExitCode> run(cli::Context& context) {
  importer::ImportOptions options;
  options.name = context.arguments().text("name");
  options.queries = !context.arguments().flag("no-queries");
  if (context.arguments().flag("explain")) return explain(context, options);
  importer::InputOpener opener(
      options, [&](const std::string& warning) { context.warn(warning); },
      [](const std::string&) {}, &context.stop());
  OBBY_ASSIGN(io::StreamWriter output, context.openOutput());
  io::SourceOptions source = context.sourceOptions();
  source.open = [&](const std::string& path) { return opener.open(path); };
  io::Pipeline pipeline(std::move(source), context.identity(), std::move(output));
  io::Physics physics;
  const Status done = pipeline.runAndFinish([&](const io::Record& record) -> Result<io::Then> {
    if (record.which() == io::Kind::PARAMS) physics.know(record);
    if (record.which() != io::Kind::LEVEL || !physics.known()) return io::Then::pass;
    OBBY_RETURN_IF_ERROR(pipeline.write(physics.applied(record).reader()));
    return io::Then::drop;
  });
  if (!done) return done.error();
  return cli::ExitCode::ok;
}

}  // namespace

int main(int argc, char** argv) {
  return obby::cli::runTool(obby::tools::importSpec(), argc, argv, run);
}
