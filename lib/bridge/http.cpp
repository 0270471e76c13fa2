#include "bridge/http.h"

#include <arpa/inet.h>
#include <errno.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <strings.h>
#include <sys/socket.h>

#include <cstring>

#include "bridge/body.h"
#include "bridge/events.h"

namespace obby::bridge {
namespace {

constexpr int kBacklog = 64;

std::optional<std::string_view> valueOf(const kj::HttpHeaders& headers, kj::HttpHeaderId id) {
  KJ_IF_MAYBE (value, headers.get(id)) {
    return std::string_view(value->begin(), value->size());
  }
  return {};
}

// Likewise of a header without id. The library takes an empty header with an id for an absent one.
std::optional<std::string_view> valueOf(const kj::HttpHeaders& headers, const char* name) {
  std::optional<std::string_view> out;
  headers.forEach([&](kj::StringPtr found, kj::StringPtr value) {
    if (strcasecmp(found.cStr(), name) == 0) out = std::string_view(value.begin(), value.size());
  });
  return out;
}

kj::Duration seconds(double count) { return uint64_t(count * 1000) * kj::MILLISECONDS; }

Error portError(uint16_t port, const char* what) {
  const bool busy = errno == EADDRINUSE;
  return Error{{},
               {},
               fmt::format("--port {}", port),
               fmt::format("cannot {}: {}", what, std::strerror(errno)),
               busy ? "another bridge may be running; --port names another port" : ""};
}

}  // namespace

Result<Listener> listenOn(uint16_t port) {
  OwnedFd fd(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (fd.get() < 0) return portError(port, "make a socket");
  const int on = 1;  // a port is free again as soon as its bridge has ended
  setsockopt(fd.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* general = reinterpret_cast<sockaddr*>(&address);
  if (bind(fd.get(), general, size) != 0 || listen(fd.get(), kBacklog) != 0) {
    return portError(port, "listen");
  }
  if (getsockname(fd.get(), general, &size) != 0) return portError(port, "listen");
  return Listener{std::move(fd), ntohs(address.sin_port)};
}

HttpFront::HttpFront(Service& service, Listener listener, Note note)
    : service_(service), note_(std::move(note)), port_(listener.port), tasks_(*this) {
  kj::HttpHeaderTable::Builder builder;
  authorization_ = builder.add("Authorization");
  contentEncoding_ = builder.add("Content-Encoding");
  cacheControl_ = builder.add("Cache-Control");
  sniffing_ = builder.add("X-Content-Type-Options");
  table_ = builder.build();
  receiver_ = service.loop().io.wrapListenSocketFd(
      listener.fd.release(), kj::LowLevelAsyncIoProvider::TAKE_OWNERSHIP |
                                 kj::LowLevelAsyncIoProvider::ALREADY_CLOEXEC |
                                 kj::LowLevelAsyncIoProvider::ALREADY_NONBLOCK);
  kj::HttpServerSettings settings;
  settings.headerTimeout = seconds(service.limits().requestSeconds);
  settings.errorHandler = static_cast<kj::HttpServerErrorHandler&>(*this);
  server_ = kj::heap<kj::HttpServer>(service.loop().timer, *table_,
                                     static_cast<kj::HttpService&>(*this), settings);
}

kj::Promise<void> HttpFront::run() {
  return receiver_->accept().then([this](kj::Own<kj::AsyncIoStream>&& connection) {
    if (open_ < service_.limits().connections) {
      open_++;
      tasks_.add(server_->listenHttp(kj::mv(connection)).attach(kj::defer([this] { open_--; })));
    } else {
      note_("a connection was refused: too many are open");
    }
    return run();
  });
}

// A client that went away, or sent no HTTP: its connection is closed, nobody else need know.
void HttpFront::taskFailed(kj::Exception&& exception) {
  note_(std::string("a connection ended: ") + exception.getDescription().cStr());
}

std::variant<Call, Reply> HttpFront::check(kj::HttpMethod method, kj::StringPtr url,
                                           const kj::HttpHeaders& headers) const {
  const kj::String name = kj::str(method);
  RequestHead head;
  head.method = std::string_view(name.begin(), name.size());
  head.target = std::string_view(url.begin(), url.size());
  head.host = valueOf(headers, kj::HttpHeaderId::HOST);
  head.origin = valueOf(headers, "Origin");
  head.fetchSite = valueOf(headers, "Sec-Fetch-Site");
  head.authorization = valueOf(headers, authorization_);
  head.contentType = valueOf(headers, kj::HttpHeaderId::CONTENT_TYPE);
  head.encoding = valueOf(headers, contentEncoding_);
  head.upgrade = valueOf(headers, kj::HttpHeaderId::UPGRADE).has_value();
  head.webSocket = headers.isWebSocket();
  head.webSocketVersion = valueOf(headers, kj::HttpHeaderId::SEC_WEBSOCKET_VERSION);
  head.webSocketKey = valueOf(headers, kj::HttpHeaderId::SEC_WEBSOCKET_KEY);
  return checkRequest(head, {port_, service_.needToken(),
                             [this](std::string_view token) { return service_.clientOf(token); }});
}

kj::Promise<void> HttpFront::request(kj::HttpMethod method, kj::StringPtr url,
                                     const kj::HttpHeaders& headers,
                                     kj::AsyncInputStream& requestBody, Response& response) {
  auto checked = check(method, url, headers);
  if (Reply* refusal = std::get_if<Reply>(&checked)) {
    note_(fmt::format("refused with {}: {}", refusal->status, refusal->body));
    return send(std::move(*refusal), response);
  }
  Call call = std::get<Call>(std::move(checked));
  if (call.endpoint == Endpoint::events) return openEvents(call, response);
  if (call.content == Content::none) {
    return service_.handle(call, {}).then(
        [this, &response](Reply reply) { return send(std::move(reply), response); });
  }
  const bool gzip = call.gzip;
  return readBody(requestBody, gzip, service_.limits(), service_.loop().timer)
      .then([this, call = std::move(call)](std::variant<std::string, Reply> body) mutable {
        if (Reply* refusal = std::get_if<Reply>(&body)) {
          return kj::Promise<Reply>(std::move(*refusal));
        }
        return service_.handle(call, std::get<std::string>(std::move(body)));
      })
      .then([this, &response](Reply reply) { return send(std::move(reply), response); });
}

kj::Promise<void> HttpFront::openEvents(const Call& call, Response& response) {
  auto opened = service_.events(call);
  if (Reply* refusal = std::get_if<Reply>(&opened)) return send(std::move(*refusal), response);
  auto client = std::get<std::shared_ptr<Client>>(std::move(opened));
  const uint64_t cursor = call.cursor.value_or(client->ring().last());
  auto socket = response.acceptWebSocket(kj::HttpHeaders(*table_));
  return sendEvents(kj::mv(socket), std::move(client), service_, cursor);
}

kj::HttpHeaders HttpFront::replyHeaders(const Reply& reply) const {
  kj::HttpHeaders headers(*table_);
  headers.set(kj::HttpHeaderId::CONTENT_TYPE, kj::str(reply.type.c_str()));
  headers.set(cacheControl_, "no-store");
  headers.set(sniffing_, "nosniff");
  return headers;
}

kj::Promise<void> HttpFront::send(Reply reply, Response& response) {
  auto body = kj::heap<std::string>(std::move(reply.body));
  auto stream =
      response.send(uint(reply.status), reason(reply.status), replyHeaders(reply), body->size());
  auto written = stream->write(body->data(), body->size());
  return service_.loop()
      .timer.timeoutAfter(seconds(service_.limits().requestSeconds), kj::mv(written))
      .attach(kj::mv(stream), kj::mv(body));
}

kj::Promise<void> HttpFront::handleClientProtocolError(kj::HttpHeaders::ProtocolError error,
                                                       Response& response) {
  return send(refuse(int(error.statusCode), error.description.cStr(), "send HTTP/1.1"), response);
}

kj::Promise<void> HttpFront::handleApplicationError(kj::Exception exception,
                                                    kj::Maybe<Response&> response) {
  if (exception.getType() == kj::Exception::Type::DISCONNECTED) return kj::READY_NOW;
  note_(std::string("a request failed: ") + exception.getDescription().cStr());
  KJ_IF_MAYBE (answer, response) {
    const bool slow = exception.getType() == kj::Exception::Type::OVERLOADED;
    return send(slow ? refuse(408, "the request came too slowly", "send it at once")
                     : refuse(500, "the bridge failed at this request", "obby-bridge -v says more"),
                *answer);
  }
  return kj::READY_NOW;
}

}  // namespace obby::bridge
