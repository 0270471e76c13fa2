#include "io/message_codec.h"

#include <capnp/serialize-packed.h>
#include <capnp/serialize.h>
#include <fmt/format.h>
#include <kj/io.h>

#include <algorithm>

#include "io/framing.h"
#include "io/normal_form.h"
#include "io/unpacker.h"

namespace obby::io {
namespace {

using Words = std::vector<uint64_t>;

constexpr uint32_t kMaxSegments = 512;
// Limit on the words that reading may visit, as a multiple of the message's words. Small messages
// get at least the floor.
constexpr uint64_t kTraversalFactor = 4, kTraversalFloor = uint64_t(64) << 10;

uint32_t half(const Words& words, size_t i) {
  uint32_t out = 0;
  std::memcpy(&out, reinterpret_cast<const char*>(words.data()) + 4 * i, 4);
  return out;
}

Error cutOff() { return makeError("the input ends in the middle of a message", kCutOffHint); }

// Returns true if `begin` is text. No packed message of one segment, as all of ours are, begins
// like text: the pointer to its root has control characters.
bool isText(std::string_view begin) {
  return std::none_of(begin.begin(), begin.end(), [](char c) {
    return uint8_t(c) < 0x20 && c != '\t' && c != '\r' && c != '\n';
  });
}

// Returns the number of words in the segment table. `words` has at least the first of them.
Result<size_t> tableWords(const Words& words) {
  const uint64_t segments = uint64_t(half(words, 0)) + 1;
  if (segments > kMaxSegments)
    return makeError(
        fmt::format("expected a message of at most {} segments, found {}", kMaxSegments, segments));
  return size_t(segments / 2 + 1);
}

// Returns the number of words in all segments. `words` has the whole segment table.
Result<size_t> bodyWords(const Words& words) {
  const uint64_t segments = uint64_t(half(words, 0)) + 1;
  uint64_t sum = 0;
  for (uint64_t i = 0; i < segments; i++) sum += half(words, i + 1);
  if (sum > kMaxMessageWords)
    return makeError(fmt::format("expected a message of at most {} MiB, found {} MiB",
                                 kMaxMessageWords >> 17, sum >> 17));
  return size_t(sum);
}

// Moves words from the source until `words` has `want` of them.
class WordReader {
 public:
  WordReader(ByteSource& source, bool packed, RawMessage& out)
      : source_(source), packed_(packed), out_(out) {}

  Status extend(size_t want) { return packed_ ? extendPacked(want) : extendPlain(want); }

 private:
  Status extendPlain(size_t want) {
    const size_t have = out_.words.size(), bytes = (want - have) * 8;
    OBBY_ASSIGN(const bool there, source_.need(bytes));
    if (!there) return cutOff();
    out_.words.resize(want);
    std::memcpy(out_.words.data() + have, source_.buffered().data(), bytes);
    take(bytes);
    return {};
  }

  Status extendPacked(size_t want) {
    for (;;) {
      size_t used = 0;
      const auto state = Unpacker::step(source_.buffered(), want, out_.words, used);
      take(used);
      if (state == Unpacker::State::done) return {};
      if (state == Unpacker::State::overrun)
        return makeError("a packed run of words extends beyond the end of its message");
      OBBY_ASSIGN(const size_t came, source_.fill());
      if (came == 0) return cutOff();
    }
  }

  void take(size_t bytes) {
    out_.bytes.append(source_.buffered().substr(0, bytes));
    source_.consume(bytes);
  }

  ByteSource& source_;
  bool packed_;
  RawMessage& out_;
};

}  // namespace

Result<std::optional<RawMessage>> readMessage(ByteSource& source, bool packed) {
  OBBY_ASSIGN(const bool any, source.need(1));
  if (!any) return std::optional<RawMessage>();
  RawMessage out;
  WordReader reader(source, packed, out);
  OBBY_RETURN_IF_ERROR(reader.extend(1));
  OBBY_ASSIGN(const size_t table, tableWords(out.words));
  OBBY_RETURN_IF_ERROR(reader.extend(table));
  OBBY_ASSIGN(const size_t body, bodyWords(out.words));
  OBBY_RETURN_IF_ERROR(reader.extend(table + body));
  return std::optional<RawMessage>(std::move(out));
}

Result<std::optional<RecordBuilder>> recordFromWords(const Words& words) {
  try {
    capnp::ReaderOptions options;
    options.traversalLimitInWords = kTraversalFloor + kTraversalFactor * words.size();
    options.nestingLimit = kMaxNesting;
    capnp::FlatArrayMessageReader message(
        kj::arrayPtr(reinterpret_cast<const capnp::word*>(words.data()), words.size()), options);
    const auto record = message.getRoot<schema::Record>();
    if (capnp::DynamicStruct::Reader(record).which() == nullptr)
      return std::optional<RecordBuilder>();
    OBBY_ASSIGN(RecordBuilder copy, normalForm(record, words.size()));
    return std::optional<RecordBuilder>(std::move(copy));
  } catch (const kj::Exception& e) {
    return unsoundMessage(e);
  }
}

Result<std::string> messageFromRecord(schema::Record::Reader record, bool packed) {
  const uint64_t words = std::min<uint64_t>(record.totalSize().wordCount, kMaxMessageWords);
  OBBY_ASSIGN(RecordBuilder copy, normalForm(record, words));
  kj::VectorOutputStream out;
  if (packed) {
    capnp::writePackedMessage(out, copy.message());
  } else {
    capnp::writeMessage(out, copy.message());
  }
  const auto bytes = out.getArray().asChars();
  return std::string(bytes.begin(), bytes.size());
}

Looks looksLikeMessage(std::string_view begin) {
  // An unpacked message starts with the little-endian count of its segments minus one. Read the
  // same way, a packed message starts with a huge count. Its first bytes are a tag, at most two
  // bytes of the count, bytes of the first segment's size, and the tag of the next word. None of
  // these is zero.
  if (begin.size() < 4) return Looks::neither;
  uint32_t segments = 0;
  std::memcpy(&segments, begin.data(), 4);
  if (segments < kMaxSegments) return Looks::unpacked;
  if (isText(begin)) return Looks::neither;
  Words words;
  size_t used = 0;
  const auto state = Unpacker::step(begin, 1, words, used);
  if (state != Unpacker::State::done || half(words, 0) >= kMaxSegments) return Looks::neither;
  const uint32_t first = half(words, 1);
  return first > 0 && first <= kMaxMessageWords ? Looks::packed : Looks::neither;
}

}  // namespace obby::io
