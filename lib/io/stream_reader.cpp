// StreamReader: detects the encoding, reads lines or messages, and checks the frame around them.
#include <fmt/format.h>

#include <new>

#include "io/byte_source.h"
#include "io/framing.h"
#include "io/json_codec.h"
#include "io/lost_level.h"
#include "io/message_codec.h"
#include "io/record_storage.h"
#include "io/stream.h"
#include "io/text.h"
#include "io/version.h"

namespace obby::io {
namespace {

constexpr size_t kMaxLine = size_t(1) << 30;
constexpr size_t kSniff = 10;  // max bytes of one packed word

bool startsJson(char c) { return c == '{' || c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

constexpr std::string_view kZip = "PK\x03\x04";  // could be the tag and size of a packed message

// Returns the error for bytes that begin no stream. `name` is the input as a word of a command
// line; empty for standard input.
Error strangeBytes(std::string_view begin, const std::string& name) {
  if (begin.substr(0, 8) == "<roblox!" || begin.substr(0, 7) == "<roblox")
    return makeError("expected a stream of records, found a Roblox file",
                     "convert it with obby-import");
  if (begin[0] == '[')
    return makeError("expected one record per line, found a JSON array",
                     "write each element on its own line: jq -c '.[]'" + name);
  if (begin.substr(0, 2) == "\x1f\x8b" || begin.substr(0, 4) == "\x28\xb5\x2f\xfd" ||
      begin.substr(0, 4) == kZip)
    return makeError("expected a stream of records, found compressed data", "decompress it first");
  return makeError(fmt::format("expected JSON lines or Cap'n Proto messages, found {}",
                               described(begin.substr(0, 8))),
                   "convert a place file with obby-import, or make levels with obby-gen");
}

}  // namespace

struct StreamReader::Impl {
  explicit Impl(ByteSource bytes) : source(std::move(bytes)) {}

  ByteSource source;
  Framing framing;
  std::optional<Format> format;
  std::optional<Error> final;  // returned again by every later call
  uint64_t line = 0;
  uint64_t messageAt = 0;  // offset of the message being read
  bool atEnd = false;
  bool lostLevel = false;                         // the last record, see StreamReader::lostLevel()
  std::shared_ptr<const Record::Storage> unread;  // the last record, if unreadable

  using Next = Result<std::optional<Record>>;

  Error located(Error error, const std::string& place) const {
    if (error.input.empty()) error.input = source.name();
    if (error.place.empty()) error.place = place;
    return error;
  }

  Error fatal(Error error, const std::string& place) {
    final = located(std::move(error), place);
    return *final;
  }

  // Returns the place of the record being read.
  std::string recordPlace() const {
    if (!format) return {};
    return *format == Format::jsonl ? std::to_string(line) : fmt::format("byte {}", messageAt);
  }

  // Returns the input as a word of a command line, with the blank before it.
  std::string argument() const {
    return source.name() == kStandardInput ? std::string() : " " + source.name();
  }

  // Detects the encoding. Returns false at the end of the input.
  Result<bool> sniff() {
    OBBY_ASSIGN(const bool any, source.need(1));
    if (!any) return false;
    if (startsJson(source.buffered()[0])) {
      format = Format::jsonl;
      return true;
    }
    OBBY_RETURN_IF_ERROR(source.need(kSniff));
    const std::string_view begin = source.buffered();
    if (begin.starts_with(kByteOrderMark)) {
      source.consume(kByteOrderMark.size());
      format = Format::jsonl;
      return true;
    }
    const bool zip = begin.substr(0, kZip.size()) == kZip;
    const Looks looks = zip ? Looks::neither : looksLikeMessage(begin.substr(0, kSniff));
    if (looks == Looks::neither && begin.size() >= 4) return strangeBytes(begin, argument());
    if (looks == Looks::neither) format = begin[0] == 0 ? Format::capnp : Format::jsonl;
    if (looks == Looks::unpacked) format = Format::capnp;
    if (looks == Looks::packed) format = Format::capnpPacked;
    return true;
  }

  // Returns the next line that is not blank, without its newline, or nothing at the end.
  Result<std::optional<std::string>> readLine() {
    for (;;) {
      line++;
      size_t scanned = 0, length = 0;
      bool newline = false;
      for (;;) {
        length = source.buffered().find('\n', scanned);
        newline = length != std::string_view::npos;
        if (newline) break;
        scanned = length = source.buffered().size();
        if (scanned > kMaxLine)
          return makeError("expected a line of at most 1 GiB, found a longer one");
        OBBY_ASSIGN(const size_t came, source.fill());
        if (came == 0) break;
      }
      if (source.stopped() || (!newline && length == 0)) return std::optional<std::string>();
      std::string text(source.buffered().substr(0, length));
      source.consume(length + (newline ? 1 : 0));
      if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
      if (!newline && framing.inside())
        return makeError("the last line has no newline", kCutOffHint);
      return std::optional<std::string>(std::move(text));
    }
  }

  Next finish() {
    atEnd = true;
    if (source.stopped()) return std::optional<Record>();
    if (Status status = framing.atEnd(); !status) return fatal(status.error(), "");
    return std::optional<Record>();
  }

  Next deliver(std::shared_ptr<Record::Storage> storage, Result<std::optional<RecordBuilder>> got) {
    std::optional<schema::Record::Reader> reader;
    if (got && *got) reader = (*got)->reader();
    const uint32_t oldest = *format == Format::jsonl ? kOldestJsonMajor : kSchemaMajor;
    if (Status status = framing.accept(reader, placeName(storage->place), oldest); !status)
      return fatal(status.error(), storage->place);
    storage->input = source.name();
    if (!got) {
      Error error = located(std::move(got).error(), storage->place);
      storage->unreadable = true;
      unread = std::move(storage);
      return error;
    }
    storage->decoded = std::move(*got);
    return std::optional<Record>(Record(std::move(storage)));
  }

  std::string placeName(const std::string& place) const {
    return *format == Format::jsonl ? "line " + place : place;
  }

  Next nextLine() {
    auto text = readLine();
    if (!text) return fatal(text.error(), recordPlace());
    if (!*text) return finish();
    auto storage = std::make_shared<Record::Storage>();
    storage->place = recordPlace();
    storage->raw = std::move(**text);
    auto decoded =
        recordFromJsonIfKnown(storage->raw, framing.later() ? nullptr : &storage->misspelt);
    lostLevel = !decoded && mayBeLevel(storage->raw);
    if (!decoded && endsInside(decoded.error())) decoded.error() = notOneLine(decoded.error());
    return deliver(std::move(storage), std::move(decoded));
  }

  // The usual cause is a record that is printed over several lines.
  Error notOneLine(const Error& error) const {
    return makeError(error.message + "; expected one record per line",
                     "join the lines of each record: jq -c ." + argument());
  }

  Next nextMessage() {
    messageAt = source.offset();
    auto message = readMessage(source, *format == Format::capnpPacked);
    if (source.stopped()) return finish();
    if (!message) return fatal(message.error(), recordPlace());
    if (!*message) return finish();
    auto storage = std::make_shared<Record::Storage>();
    storage->place = recordPlace();
    storage->format = *format;
    storage->raw = std::move((*message)->bytes);
    auto decoded = recordFromWords((*message)->words);
    lostLevel = !decoded && mayBeLevel((*message)->words);
    return deliver(std::move(storage), std::move(decoded));
  }

  Next next() {
    if (final) return *final;
    if (atEnd) return std::optional<Record>();
    if (!format) {
      auto sniffed = sniff();
      if (!sniffed) return fatal(sniffed.error(), "");
      if (!*sniffed) return finish();
    }
    return *format == Format::jsonl ? nextLine() : nextMessage();
  }
};

Result<StreamReader> StreamReader::open(const std::string& path, const std::atomic<bool>* stop) {
  OBBY_ASSIGN(ByteSource source, ByteSource::open(path, stop));
  return over(std::move(source));
}

StreamReader StreamReader::overBytes(std::string bytes, std::string name) {
  return over(ByteSource::overBytes(std::move(bytes), std::move(name)));
}

StreamReader StreamReader::over(ByteSource source) {
  return StreamReader(std::make_unique<Impl>(std::move(source)));
}

StreamReader::StreamReader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
StreamReader::StreamReader(StreamReader&&) noexcept = default;
StreamReader& StreamReader::operator=(StreamReader&&) noexcept = default;
StreamReader::~StreamReader() = default;

Result<std::optional<Record>> StreamReader::next() {
  try {
    return impl_->next();
  } catch (const std::bad_alloc&) {
    return impl_->fatal(
        makeError(
            "not enough memory for this record",
            "make the record smaller, free some memory, or raise the limit if ulimit -v shows one"),
        impl_->recordPlace());
  }
}

bool StreamReader::canContinue() const { return !impl_->final && !impl_->atEnd; }
bool StreamReader::lostLevel() const { return impl_->lostLevel; }
Record StreamReader::unread() const { return Record(impl_->unread); }
bool StreamReader::stopped() const { return impl_->source.stopped(); }
const std::string& StreamReader::name() const { return impl_->source.name(); }
Format StreamReader::format() const { return impl_->format.value_or(Format::jsonl); }

}  // namespace obby::io
