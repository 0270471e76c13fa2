#include "bridge/body.h"

#include <fmt/format.h>
#include <kj/compat/gzip.h>

#include <memory>

namespace obby::bridge {
namespace {

using Body = std::variant<std::string, Reply>;

struct Bounds {
  uint64_t sent;      // bytes
  uint64_t inflated;  // equal to `sent` for a plain body
  const char* cure;
};

Bounds boundsOf(const Call& call, const Limits& limits) {
  // No token is needed to send this, so it must not cost memory.
  if (call.endpoint == Endpoint::pair) {
    return {limits.pairBytes, limits.pairBytes, "send only the code"};
  }
  return {limits.bodyBytes, call.gzip ? limits.inflatedBytes : limits.bodyBytes,
          "send less, or start obby-bridge with a larger --max-body"};
}

Reply tooLarge(uint64_t limit, const char* what, const char* cure) {
  const bool whole = limit % kMiB == 0;
  return refuse(413,
                fmt::format("{} is larger than {} {}", what, limit / (whole ? kMiB : 1024),
                            whole ? "MiB" : "KiB"),
                cure);
}

// Counts the bytes that pass: a gzip stream can be long and inflate to nothing.
class Counting final : public kj::AsyncInputStream {
 public:
  Counting(kj::AsyncInputStream& from, uint64_t limit) : from_(from), limit_(limit) {}
  bool over() const { return bytes_ > limit_; }
  bool ended() const { return ended_; }

  kj::Promise<size_t> tryRead(void* buffer, size_t minBytes, size_t maxBytes) override {
    return from_.tryRead(buffer, minBytes, maxBytes).then([this](size_t n) -> size_t {
      bytes_ += n;
      ended_ = n == 0;
      return over() ? 0 : n;  // ends here; the caller checks over()
    });
  }

 private:
  kj::AsyncInputStream& from_;
  uint64_t limit_, bytes_ = 0;
  bool ended_ = false;
};

struct Reader {
  Reader(kj::AsyncInputStream& from, bool gzip, const Bounds& bounds)
      : bounds_(bounds), sent_(from, bounds.sent) {
    if (gzip) inflated_ = kj::heap<kj::GzipAsyncInputStream>(sent_);
  }

  kj::Promise<Body> read() {
    kj::AsyncInputStream& from =
        inflated_.get() ? static_cast<kj::AsyncInputStream&>(*inflated_) : sent_;
    return from.tryRead(buffer_, 1, sizeof buffer_).then([this](size_t n) -> kj::Promise<Body> {
      if (sent_.over()) return Body(sentTooMuch());
      if (n == 0) return Body(std::move(out_));
      if (out_.size() + n > bounds_.inflated) {
        return Body(tooLarge(bounds_.inflated, "the decompressed body", bounds_.cure));
      }
      out_.append(buffer_, n);
      return read();
    });
  }

  Reply sentTooMuch() const { return tooLarge(bounds_.sent, "the body", bounds_.cure); }

  const Bounds bounds_;
  Counting sent_;
  kj::Own<kj::GzipAsyncInputStream> inflated_;
  std::string out_;
  char buffer_[32768];
};

}  // namespace

kj::Promise<Body> readBody(kj::AsyncInputStream& body, const Call& call, const Limits& limits,
                           kj::Timer& timer) {
  auto reader = kj::heap<Reader>(body, call.gzip, boundsOf(call, limits));
  KJ_IF_MAYBE (length, body.tryGetLength()) {
    if (*length > reader->bounds_.sent) return Body(reader->sentTooMuch());
  }
  auto read = reader->read();
  if (call.gzip) {
    Reader* r = reader.get();
    read = read.catch_([r](kj::Exception&& e) -> Body {
      // The library also reports DISCONNECTED for a stream that is cut.
      const bool gone = e.getType() == kj::Exception::Type::DISCONNECTED && !r->sent_.ended();
      if (gone) kj::throwFatalException(kj::mv(e));
      if (r->sent_.over()) return r->sentTooMuch();
      return refuse(400, "the body is not a gzip stream",
                    "send it uncompressed, or gzip all of it");
    });
  }
  const auto late = uint64_t(limits.requestSeconds * 1000) * kj::MILLISECONDS;
  return read
      .exclusiveJoin(timer.afterDelay(late).then(
          [] { return Body(refuse(408, "the body arrived too slowly", "send it faster")); }))
      .attach(kj::mv(reader));
}

}  // namespace obby::bridge
