#include "view/live_server.h"

#include <fmt/format.h>

#include "loopback/secrets.h"
#include "view/live_request.h"

namespace obby::view {
namespace {

using loopback::Reply;

constexpr auto kNewsLook = 20 * kj::MILLISECONDS;  // interval between checks for a new revision
// Interval of empty event lines. A closed connection is noticed only by writing.
constexpr auto kPing = 1 * kj::SECONDS;
constexpr loopback::ServerLimits kLimits = {32, 60};  // a browser opens at most six

// Notifies one page of new revisions until it disconnects.
class Events {
 public:
  using InTime = kj::Function<kj::Promise<void>(kj::Promise<void>)>;
  Events(kj::Own<kj::AsyncOutputStream> stream, const LiveData& data, kj::Timer& timer,
         InTime inTime)
      : stream_(kj::mv(stream)), data_(data), timer_(timer), inTime_(kj::mv(inTime)) {}

  // Ends only by an exception.
  kj::Promise<void> run() { return write("retry: 1000\n\n"); }

 private:
  kj::Promise<void> write(std::string text) {
    text_ = std::move(text);
    next_ = timer_.now() + kPing;
    return inTime_(stream_->write(text_.data(), text_.size())).then([this] { return go(); });
  }

  // A slow page receives only the newest revision, because one request fetches all the data.
  kj::Promise<void> go() {
    if (sent_ != data_.revision()) {
      sent_ = data_.revision();
      return write(fmt::format("data: {{\"revision\":{}}}\n\n", sent_));
    }
    if (timer_.now() >= next_) return write(":\n\n");
    return timer_.afterDelay(kNewsLook).then([this] { return go(); });
  }

  kj::Own<kj::AsyncOutputStream> stream_;
  const LiveData& data_;
  kj::Timer& timer_;
  InTime inTime_;
  uint64_t sent_ = 0;
  kj::TimePoint next_ = kj::origin<kj::TimePoint>();
  std::string text_;  // being sent
};

}  // namespace

LiveServer::LiveServer(kj::AsyncIoContext& io, loopback::Listener listener, const LiveData& data,
                       std::string page, loopback::Note note)
    : Server(*io.lowLevelProvider, io.provider->getTimer(), std::move(listener), kLimits,
             std::move(note)),
      timer_(io.provider->getTimer()),
      data_(data),
      page_(std::move(page)),
      token_(loopback::randomHex(loopback::kTokenBytes)),
      lastSeen_(timer_.now()) {}

std::string LiveServer::address() const {
  return fmt::format("http://127.0.0.1:{}/?token={}", port(), token_);
}

double LiveServer::quietFor() const {
  if (open_ > 0) return 0;
  return double((timer_.now() - lastSeen_) / kj::MILLISECONDS) / 1000;
}

Reply LiveServer::failure(int status, const char* message, const char*) const {
  return {status, message, "text/plain; charset=utf-8"};
}

// Headers beyond the page's own policy: no framing, and links do not leak the token.
kj::HttpHeaders LiveServer::pageHeaders(const std::string& type) const {
  kj::HttpHeaders headers = answerHeaders(type);
  headers.add("Content-Security-Policy", "frame-ancestors 'none'");
  headers.add("Cross-Origin-Resource-Policy", "same-origin");
  headers.add("Referrer-Policy", "no-referrer");
  return headers;
}

kj::Promise<void> LiveServer::request(kj::HttpMethod method, kj::StringPtr url,
                                      const kj::HttpHeaders& headers, kj::AsyncInputStream&,
                                      Response& response) {
  LiveHead head;
  readHead(method, url, headers, head);
  head.fetchMode = valueOf(headers, "Sec-Fetch-Mode");
  auto checked = checkLiveRequest(head, port(), token_);
  if (Reply* refusal = std::get_if<Reply>(&checked)) {
    note(fmt::format("refused a request with {}: {}", refusal->status, refusal->body));
    return send(std::move(*refusal), response);
  }
  lastSeen_ = timer_.now();
  const LiveCall call = std::get<LiveCall>(checked);
  if (call.route == LiveRoute::events) return sendEvents(response);
  const bool page = call.route == LiveRoute::page;
  Reply reply{200, page ? page_ : data_.since(call.from),
              page ? "text/html; charset=utf-8" : "application/json"};
  const kj::HttpHeaders answer = pageHeaders(reply.type);
  return send(std::move(reply), answer, response);
}

kj::Promise<void> LiveServer::sendEvents(Response& response) {
  auto stream = response.send(200, "OK", pageHeaders("text/event-stream"));
  auto events = kj::heap<Events>(kj::mv(stream), data_, timer_, [this](kj::Promise<void> written) {
    return inTime(kj::mv(written));
  });
  open_++;
  auto gone = kj::defer([this] {
    open_--;
    lastSeen_ = timer_.now();
  });
  auto done = events->run();
  return done.attach(kj::mv(events), kj::mv(gone));
}

}  // namespace obby::view
