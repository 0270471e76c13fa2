// obby-import: converts place and model files to levels and queries. Wiring only; lib/import does
// the work.
#include "cli/context.h"
#include "cli/tool.h"
#include "import/filter.h"
#include "io/physics.h"
#include "io/pipeline.h"
#include "io/read_file.h"
#include "options.h"

namespace {

using namespace obby;

// Options for records do not apply to a table.
Status refuseOptionsOfRecords(const cli::Arguments& a) {
  return cli::refuseTyped(
      a, {"format", "no-queries"}, "cannot be combined with --explain",
      "leave out this option, because --explain writes a table instead of records");
}

// Writes the tables of all inputs. Stops at an input that ends the run, and returns its error.
// Under --on-error skip and emit, a broken input is reported and left out. `any`: a table was
// written.
Status tables(cli::Context& context, const importer::ImportOptions& options, io::Sink& sink,
              bool& any) {
  Status written;
  importer::InputOpener opener(
      options, [&](const std::string& warning) { context.note(warning); },
      [&](const std::string& table) {
        if (written) written = sink.write(any ? "\n" + table : table);
        any = true;
      },
      &context.stop());
  const bool goesOn = context.sourceOptions().onError != io::OnError::stop;
  for (const std::string& path : context.inputs()) {
    if (context.stop()) break;
    const auto opened = opener.open(path);
    if (!written) return written;
    if (opened) continue;
    if (!goesOn || io::isInterrupted(opened.error())) return opened.error();
    context.error(opened.error());
  }
  return {};
}

Result<cli::ExitCode> explain(cli::Context& context, importer::ImportOptions options) {
  OBBY_RETURN_IF_ERROR(refuseOptionsOfRecords(context.arguments()));
  OBBY_ASSIGN(io::Sink sink, context.openSink());
  options.explain = true;
  bool any = false;
  const Status done = tables(context, options, sink, any);
  if (!done && !any) return done.error();  // nothing was written, so no output is left
  const Status closed = sink.close();
  if (!done) return done.error();
  if (!closed) return closed.error();
  return cli::ExitCode::ok;
}

Result<cli::ExitCode> run(cli::Context& context) {
  importer::ImportOptions options;
  options.name = context.arguments().text("name");
  options.queries = !context.arguments().flag("no-queries");
  options.runScripts = !context.arguments().flag("no-scripts");
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
