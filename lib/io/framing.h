// The rules of a stream's frame. A header begins it, and an end record with the right count closes
// it. Streams may follow one another, and a hand-written stream needs no frame. Private to lib/io.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/result.h"
#include "io/record.h"

namespace obby::io {

// The hint for an input that is incomplete.
inline constexpr const char* kCutOffHint = "the input was cut off; rerun the tool that wrote it";

class Framing {
 public:
  // Accepts every record in order. `record` is nothing if it was bad or of an unknown kind.
  // `oldestMajor` is the oldest schema version that the format can be read in. Errors lack the
  // input and the place.
  Status accept(const std::optional<schema::Record::Reader>& record, const std::string& place,
                uint32_t oldestMajor);
  // Returns an error if the input must not end here.
  Status atEnd() const;
  // Returns true inside a stream with a header, where a line without its newline was cut off.
  bool inside() const { return inside_; }
  // Returns true if the stream's header has a later minor version, so that it may have unknown
  // fields.
  bool later() const { return later_; }

 private:
  Status acceptHeader(schema::Header::Reader header, const std::string& place,
                      uint32_t oldestMajor);
  Status acceptEnd(schema::End::Reader end);

  bool inside_ = false, later_ = false;
  std::string headerPlace_;
  uint64_t inStream_ = 0;  // records since the header, including it
  uint64_t total_ = 0;
};

}  // namespace obby::io
