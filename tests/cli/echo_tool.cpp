// The smallest tool. It only passes records through. Command-line tests use it for features that
// all tools share.
#include <unistd.h>

#include "cli/context.h"
#include "cli/rows.h"
#include "cli/tool.h"

namespace {

using namespace obby;

cli::ToolSpec spec() {
  cli::ToolSpec out;
  out.name = "obby-echo";
  out.summary = "pass records through; count levels, refuse queries without an id";
  out.examples = {{"Copy a stream", "printf '{\"type\":\"level\"}\\n' | obby-echo"},
                  {"Convert it",
                   "printf '{\"type\":\"level\"}\\n' | obby-echo --format packed | "
                   "obby-echo --format jsonl -o copy.jsonl"}};
  using cli::Common;
  for (Common option : {Common::output, Common::format, Common::seed, Common::threads,
                        Common::backend, Common::timeLimit, Common::progress, Common::onError})
    out.options.push_back(cli::commonRow(option));
  cli::OptionRow tag;
  tag.name = "tag";
  tag.type = cli::ValueType::text;
  tag.help = "add a metrics record with this source";
  tag.repeatable = true;
  out.options.push_back(tag);
  cli::OptionRow wait;
  wait.name = "wait";
  wait.help = "after the input, wait for a signal";
  out.options.push_back(wait);
  return out;
}

Result<cli::ExitCode> run(cli::Context& context) {
  OBBY_ASSIGN(io::StreamWriter output, context.openOutput());
  io::Pipeline pipeline(context.sourceOptions(), context.identity(), std::move(output));
  uint64_t levels = 0;
  const Status status = pipeline.run([&](const io::Record& record) -> Result<io::Then> {
    context.progress({"records", -1, {{"levels", double(levels)}}});
    if (record.which() == io::Kind::LEVEL) levels++;
    if (record.which() == io::Kind::QUERY && record.reader().getQuery().getId().size() == 0)
      return Error{{}, {}, "id", "expected text that is not empty, found \"\"", {}};
    return io::Then::pass;
  });
  for (const std::string& tag : context.arguments().list("tag")) {
    io::RecordBuilder metrics;
    metrics.root().initMetrics().setSource(tag);
    OBBY_RETURN_IF_ERROR(pipeline.write(metrics.reader()));
  }
  if (context.arguments().flag("wait")) {
    OBBY_RETURN_IF_ERROR(pipeline.output().flush());
    while (!context.stop()) usleep(1000);
  }
  context.note(std::to_string(levels) + " levels");
  if (!pipeline.output().failed()) OBBY_RETURN_IF_ERROR(pipeline.finish());
  if (!status) return status.error();
  return cli::ExitCode::ok;
}

}  // namespace

int main(int argc, char** argv) { return obby::cli::runTool(spec(), argc, argv, run); }
