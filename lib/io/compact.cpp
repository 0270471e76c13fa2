#include "io/compact.h"

#include <utility>

namespace obby::io {
namespace {

// Words of a record's root, counted twice, plus a margin. The root is allocated before it is
// copied, so it takes memory twice.
constexpr uint64_t kRoot = 16;

uint64_t wordsOf(const Record& record) { return record.reader().totalSize().wordCount + kRoot; }

}  // namespace

uint64_t compactBytes(const Record& record) { return wordsOf(record) * sizeof(capnp::word); }

Record compact(const Record& record) {
  RecordBuilder copy(wordsOf(record));
  copy.message().setRoot(record.reader());
  return Record(std::move(copy));
}

}  // namespace obby::io
