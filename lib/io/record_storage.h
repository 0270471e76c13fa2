// What a Record holds. Private to lib/io.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/record.h"
#include "io/stream.h"

namespace obby::io {

struct Record::Storage {
  std::optional<RecordBuilder> decoded;  // nothing: a kind that the schema does not have
  Format format = Format::jsonl;
  std::string raw;  // the line without its newline, or the message; empty: made here
  std::string input, place;
  std::vector<Error> misspelt;  // as of recordFromJsonIfKnown()
};

}  // namespace obby::io
