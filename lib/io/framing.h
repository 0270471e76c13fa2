// The rules of a stream's frame: a header begins it, an end with the right count closes it, streams
// may follow one another, and a hand-written stream may do without. Private to lib/io.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/result.h"
#include "io/record.h"

namespace obby::io {

// The cure for an input that is not whole.
inline constexpr const char* kCutOffHint = "it was cut off: run the tool that wrote it again";

class Framing {
 public:
  // Every record in order; `record` is nothing where it was bad or of an unknown kind. Errors have
  // no input and place.
  // `oldestMajor`: of schema versions that the format can be read in.
  Status accept(const std::optional<schema::Record::Reader>& record, const std::string& place,
                uint32_t oldestMajor);
  // The input is at its end.
  Status atEnd() const;
  // Inside a stream that has a header: a line without its newline is then a cut.
  bool inside() const { return inside_; }
  // The stream's header is of a later minor version: it may have fields that the schema lacks.
  bool later() const { return later_; }

 private:
  Status acceptHeader(schema::Header::Reader header, const std::string& place,
                      uint32_t oldestMajor);
  Status acceptEnd(schema::End::Reader end);

  bool inside_ = false, later_ = false;
  std::string headerPlace_;
  uint64_t inStream_ = 0;  // records since the header, it included
  uint64_t total_ = 0;
};

}  // namespace obby::io
