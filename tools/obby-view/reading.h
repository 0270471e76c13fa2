// Reads obby-view's inputs into a report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/context.h"
#include "io/pipeline.h"
#include "view/report.h"

namespace obby {

class Reading {
 public:
  // `stop` ends the inputs early.
  Reading(cli::Context& context, const std::atomic<bool>& stop);

  // Returns the next record, or nothing at the end. A broken input is reported and counts as the
  // end.
  std::optional<io::Record> next();
  // Returns true if next() ended at a broken input.
  bool broken() const { return broken_; }

  // Reports why the rest of the input cannot be shown.
  void cannotShow(const Error& error);
  // Reads to the end and discards the records. Otherwise the writer of a pipe would block as long
  // as the page is open.
  void drain();

  // Policy for view::Collector.
  Status forgive(const io::Record& record, Error error);

  // Call it after the end. Reports that the input lacks something, unless an earlier error explains
  // the lack. That error may be a reported one, or one that stopped the program that wrote the
  // input.
  void reportLack(const Error& lack);

  // Call it after the end. Returns notes for the report's users about what is missing.
  std::vector<std::string> notes(const view::Report& report) const;

 private:
  cli::Context& context_;
  io::RecordSource source_;
  std::vector<std::string> notes_;
  bool broken_ = false;
};

// Returns the error for an empty report.
Error nothingToShow();

// Reads all inputs. A broken input and records that cannot be shown are reported; everything before
// them is shown. Returns nothing if there is nothing to show or a requested query is missing, after
// reporting it.
std::optional<view::Report> readReport(cli::Context& context);

}  // namespace obby
