#include "loopback/server.h"

#include <strings.h>

namespace obby::loopback {
namespace {

kj::Duration seconds(double count) { return uint64_t(count * 1000) * kj::MILLISECONDS; }

}  // namespace

std::optional<std::string_view> Server::valueOf(const kj::HttpHeaders& headers,
                                                kj::HttpHeaderId id) {
  KJ_IF_MAYBE (value, headers.get(id)) {
    return std::string_view(value->begin(), value->size());
  }
  return {};
}

std::optional<std::string_view> Server::valueOf(const kj::HttpHeaders& headers, const char* name) {
  std::optional<std::string_view> out;
  headers.forEach([&](kj::StringPtr found, kj::StringPtr value) {
    if (strcasecmp(found.cStr(), name) == 0) out = std::string_view(value.begin(), value.size());
  });
  return out;
}

void Server::readHead(kj::HttpMethod method, kj::StringPtr url, const kj::HttpHeaders& headers,
                      Head& out) {
  const kj::StringPtr name = kj::toCharSequence(method);  // static text of the library
  out.method = std::string_view(name.begin(), name.size());
  out.target = std::string_view(url.begin(), url.size());
  out.host = valueOf(headers, kj::HttpHeaderId::HOST);
  out.origin = valueOf(headers, "Origin");
  out.fetchSite = valueOf(headers, "Sec-Fetch-Site");
}

Server::Server(kj::LowLevelAsyncIoProvider& io, kj::Timer& timer, Listener listener,
               ServerLimits limits, Note note)
    : timer_(timer), note_(std::move(note)), limits_(limits), port_(listener.port), tasks_(*this) {
  kj::HttpHeaderTable::Builder builder;
  authorization = builder.add("Authorization");
  contentEncoding = builder.add("Content-Encoding");
  cacheControl_ = builder.add("Cache-Control");
  sniffing_ = builder.add("X-Content-Type-Options");
  table_ = builder.build();
  receiver_ = io.wrapListenSocketFd(listener.fd.release(),
                                    kj::LowLevelAsyncIoProvider::TAKE_OWNERSHIP |
                                        kj::LowLevelAsyncIoProvider::ALREADY_CLOEXEC |
                                        kj::LowLevelAsyncIoProvider::ALREADY_NONBLOCK);
  kj::HttpServerSettings settings;
  settings.headerTimeout = seconds(limits.requestSeconds);
  settings.canceledUploadGracePeriod = seconds(limits.refusedSeconds);
  settings.canceledUploadGraceBytes = limits.refusedBytes;
  settings.errorHandler = static_cast<kj::HttpServerErrorHandler&>(*this);
  server_ =
      kj::heap<kj::HttpServer>(timer, *table_, static_cast<kj::HttpService&>(*this), settings);
}

kj::Promise<void> Server::run() {
  return receiver_->accept().then([this](kj::Own<kj::AsyncIoStream>&& connection) {
    if (open_ < limits_.connections) {
      open_++;
      tasks_.add(server_->listenHttp(kj::mv(connection)).attach(kj::defer([this] { open_--; })));
    } else {
      note_("a connection was refused: too many connections are open");
    }
    return run();
  });
}

// Called if a client went away or sent no HTTP. The client's connection is closed, and nothing else
// is affected.
void Server::taskFailed(kj::Exception&& exception) {
  note_(std::string("a connection ended: ") + exception.getDescription().cStr());
}

kj::HttpHeaders Server::answerHeaders(const std::string& type) const {
  kj::HttpHeaders headers(*table_);
  headers.set(kj::HttpHeaderId::CONTENT_TYPE, kj::str(type.c_str()));
  headers.set(cacheControl_, "no-store");
  headers.set(sniffing_, "nosniff");
  return headers;
}

kj::Promise<void> Server::inTime(kj::Promise<void> written) {
  return timer_.timeoutAfter(seconds(limits_.requestSeconds), kj::mv(written));
}

kj::Promise<void> Server::send(Reply reply, Response& response) {
  const kj::HttpHeaders headers = answerHeaders(reply.type);
  return send(std::move(reply), headers, response);
}

kj::Promise<void> Server::send(Reply reply, const kj::HttpHeaders& headers, Response& response) {
  auto body = kj::heap<std::string>(std::move(reply.body));
  auto stream = response.send(uint(reply.status), reason(reply.status), headers, body->size());
  auto written = stream->write(body->data(), body->size());
  return inTime(kj::mv(written)).attach(kj::mv(stream), kj::mv(body));
}

kj::Promise<void> Server::handleClientProtocolError(kj::HttpHeaders::ProtocolError error,
                                                    Response& response) {
  return send(failure(int(error.statusCode), error.description.cStr(), "send HTTP/1.1"), response);
}

kj::Promise<void> Server::handleApplicationError(kj::Exception exception,
                                                 kj::Maybe<Response&> response) {
  if (exception.getType() == kj::Exception::Type::DISCONNECTED) return kj::READY_NOW;
  note_(std::string("a request failed: ") + exception.getDescription().cStr());
  KJ_IF_MAYBE (answer, response) {
    const bool slow = exception.getType() == kj::Exception::Type::OVERLOADED;
    return send(slow ? failure(408, "the request arrived too slowly", "send it faster")
                     : failure(500, "the server failed to answer this request",
                               "start this program with -v to see why"),
                *answer);
  }
  return kj::READY_NOW;
}

}  // namespace obby::loopback
