#include "live.h"

#include <exception>
#include <optional>

#include "output.h"
#include "reading.h"
#include "view/live.h"

namespace obby {
namespace {

// Reads all records on the reading thread. Errors are reported at once; the page shows the rest.
class Reader {
 public:
  // `output`: for the complete report; null if none is requested.
  Reader(cli::Context& context, view::GrowingReport& report, Reading& reading, Output* output)
      : context_(context), report_(report), reading_(reading), output_(output) {}

  void run() {
    while (const auto record = reading_.next()) {
      if (const Status added = report_.add(*record); !added) {
        fail(added.error());
        return reading_.drain();
      }
    }
    finish(reading_.broken() ? view::StreamState::broken : view::StreamState::ended);
    if (reading_.broken()) reading_.drain();
  }

  void fail(const Error& why) {
    reading_.cannotShow(why);
    finish(view::StreamState::broken);
  }

 private:
  void finish(view::StreamState state) {
    std::vector<std::string> notes;
    (void)report_.use([&](const view::Report& report) -> Status {
      notes = reading_.notes(report);
      return {};
    });
    if (const Status chosen = report_.end(state, notes); !chosen) {
      reading_.reportLack(chosen.error());
    }
    if (output_ == nullptr) return;
    const Status written = report_.use([&](const view::Report& report) { return write(report); });
    if (!written) context_.error(written.error());
  }

  Status write(const view::Report& report) {
    if (!report.empty()) return output_->write(report, context_);
    reading_.reportLack(nothingToShow());
    return {};
  }

  cli::Context& context_;
  view::GrowingReport& report_;
  Reading& reading_;
  Output* output_;
};

}  // namespace

Result<cli::ExitCode> runLive(cli::Context& context) {
  const cli::Arguments& arguments = context.arguments();
  std::optional<Output> output;
  if (arguments.has("output")) {
    OBBY_ASSIGN(output, Output::open(context));
  }
  const io::StreamIdentity self = context.identity();
  std::unique_ptr<Reading> reading;
  view::GrowingReport report(
      view::Collector([&](const io::Record& record,
                          Error error) { return reading->forgive(record, std::move(error)); },
                      arguments.list("query"), view::kLiveBudget));
  view::LiveOptions options;
  options.port = uint16_t(arguments.integer("port"));
  options.endWithPages = arguments.flag("live-exit");
  options.page = {arguments.flag("full"), self.tool + " " + self.version};
  const auto read = [&](const std::atomic<bool>& halt) {
    reading = std::make_unique<Reading>(context, halt);
    Reader reader(context, report, *reading, output ? &*output : nullptr);
    try {
      reader.run();
    } catch (const std::exception& e) {  // probably out of memory; the page stays open
      reader.fail(makeError(e.what()));
      reading->drain();
    }
  };
  const view::LiveReports reports = {[&](const std::string& text) { context.say(text); },
                                     [&](const std::string& text) { context.note(text); }};
  OBBY_RETURN_IF_ERROR(view::serveLive(report, read, options, context.stop(), reports));
  return cli::ExitCode::ok;
}

}  // namespace obby
