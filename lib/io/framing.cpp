#include "io/framing.h"

#include <fmt/format.h>

#include "io/version.h"

namespace obby::io {

Status Framing::accept(const std::optional<schema::Record::Reader>& record,
                       const std::string& place, uint32_t oldestMajor) {
  total_++;
  if (record && record->isHeader()) return acceptHeader(record->getHeader(), place, oldestMajor);
  if (record && record->isEnd()) return acceptEnd(record->getEnd());
  inStream_++;
  return {};
}

Status Framing::acceptHeader(schema::Header::Reader header, const std::string& place,
                             uint32_t oldestMajor) {
  if (inside_)
    return makeError(
        fmt::format("expected the end record of the stream that begins at {}, found another header",
                    headerPlace_),
        kCutOffHint);
  const uint32_t major = header.getSchemaMajor();
  if (major < oldestMajor || major > kSchemaMajor) {
    const std::string writer =
        header.getTool().size() == 0
            ? std::string()
            : fmt::format(" by {} {}", header.getTool().cStr(), header.getVersion().cStr());
    return Error{{},
                 {},
                 "schemaMajor",
                 fmt::format("the stream was written{} with schema {}.{}, but this program ({}) "
                             "reads schema {}.{}",
                             writer, header.getSchemaMajor(), header.getSchemaMinor(),
                             toolVersion(), kSchemaMajor, kSchemaMinor),
                 "use tools of the same version"};
  }
  inside_ = true;
  later_ = major == kSchemaMajor && header.getSchemaMinor() > kSchemaMinor;
  headerPlace_ = place;
  inStream_ = 1;
  return {};
}

Status Framing::acceptEnd(schema::End::Reader end) {
  const uint64_t came = inStream_;
  const bool counted = inside_ && end.getRecords() != 0;
  inside_ = later_ = false;
  inStream_ = 0;
  if (!counted || end.getRecords() == came) return {};
  return Error{{},
               {},
               "records",
               fmt::format("the end record counts {} records, but the stream has {}",
                           end.getRecords(), came),
               "the stream was cut or mixed with another; rerun the tool that wrote it"};
}

Status Framing::atEnd() const {
  if (total_ == 0)
    return makeError("the input is empty", "check the file, or the tool that writes it");
  if (inside_) return makeError("the stream ends without its end record", kCutOffHint);
  return {};
}

}  // namespace obby::io
