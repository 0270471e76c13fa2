// What a Record holds. Private to lib/io.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/format.h"
#include "io/record.h"

namespace obby::io {

struct Record::Storage {
  std::optional<RecordBuilder> decoded;  // nothing: an unknown kind, or unreadable
  bool unreadable = false;               // its error has been reported
  Format format = Format::jsonl;
  std::string raw;  // the line without its newline, or the message; empty: made here
  std::string input, place;
  std::vector<Error> misspelt;  // as of recordFromJsonIfKnown()
};

}  // namespace obby::io
