#include "reading.h"

#include <exception>

namespace obby {
namespace {

io::SourceOptions optionsOf(cli::Context& context, const std::atomic<bool>& stop) {
  io::SourceOptions options = context.sourceOptions();
  options.stop = &stop;
  return options;
}

}  // namespace

Reading::Reading(cli::Context& context, const std::atomic<bool>& stop)
    : context_(context), source_(optionsOf(context, stop)) {}

std::optional<io::Record> Reading::next() {
  auto next = source_.next();
  if (next) return *std::move(next);
  context_.error(next.error());
  notes_.push_back("The input broke off: " + next.error().text());
  broken_ = true;
  return {};
}

void Reading::cannotShow(const Error& error) {
  context_.error(error);
  notes_.push_back("The input cannot be shown: " + error.text());
}

void Reading::drain() {
  source_.ignoreErrors();
  try {
    for (;;) {
      const auto next = source_.next();
      if (!next || !*next) return;
    }
  } catch (const std::exception&) {  // above all memory that lacks: nothing is lost with it
  }
}

Status Reading::forgive(const io::Record& record, Error error) {
  // The source knows which input it reads, but not where a record of before came from.
  const std::vector<std::string>& inputs = context_.inputs();
  if (inputs.size() == 1) error.input = inputs[0] == "-" ? "stdin" : inputs[0];
  return source_.forgive(record, std::move(error));
}

std::vector<std::string> Reading::notes() const {
  std::vector<std::string> notes = notes_;
  if (source_.status() == schema::EndStatus::INTERRUPTED) {
    notes.push_back("The work was interrupted before every query had its answer.");
  } else if (source_.status() == schema::EndStatus::BUDGET) {
    notes.push_back("A budget was spent before every query had its answer.");
  }
  return notes;
}

Result<view::Report> readReport(cli::Context& context) {
  Reading reading(context, context.stop());
  view::Collector collector([&](const io::Record& record,
                                Error error) { return reading.forgive(record, std::move(error)); },
                            context.arguments().list("query"));
  Status shown;
  while (shown) {
    const auto record = reading.next();
    if (!record) break;
    shown = collector.add(*record);
  }
  Status played = collector.update();
  if (shown) shown = std::move(played);
  if (!shown) reading.cannotShow(shown.error());
  OBBY_RETURN_IF_ERROR(collector.checkChosen());
  view::Report report = collector.take();
  const std::vector<std::string> notes = reading.notes();
  report.notes.insert(report.notes.end(), notes.begin(), notes.end());
  return report;
}

}  // namespace obby
