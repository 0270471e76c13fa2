// Shows the answers at a terminal as a table instead of records.
#pragma once

#include <memory>
#include <optional>

#include "cli/context.h"
#include "table/gathering.h"

namespace obby::tools {

class TerminalTable {
 public:
  // Returns nothing if records are to be written.
  static std::optional<TerminalTable> wanted(const cli::Context& context);

  // Returns a writer that collects the answers.
  io::StreamWriter writer() const;
  // Writes the table to standard output, or nothing without answers.
  Status print(cli::Context& context) const;

 private:
  TerminalTable() = default;

  // Shared with the writer.
  std::shared_ptr<table::Gathering> gathering_ = std::make_shared<table::Gathering>();
};

}  // namespace obby::tools
