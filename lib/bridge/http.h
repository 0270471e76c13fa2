// The service over HTTP and WebSockets on the loopback interface.
#pragma once

#include <kj/compat/http.h>

#include <string>

#include "bridge/process.h"
#include "bridge/service.h"

namespace obby::bridge {

// A socket that listens on 127.0.0.1; port 0 takes any free one.
struct Listener {
  OwnedFd fd;
  uint16_t port = 0;
};
Result<Listener> listenOn(uint16_t port);

class HttpFront final : private kj::HttpService,
                        private kj::HttpServerErrorHandler,
                        private kj::TaskSet::ErrorHandler {
 public:
  using Note = std::function<void(const std::string&)>;
  HttpFront(Service& service, Listener listener, Note note);

  // Accepts and serves connections; ends only with an exception.
  kj::Promise<void> run();

 private:
  kj::Promise<void> request(kj::HttpMethod method, kj::StringPtr url,
                            const kj::HttpHeaders& headers, kj::AsyncInputStream& requestBody,
                            Response& response) override;
  kj::Promise<void> handleClientProtocolError(kj::HttpHeaders::ProtocolError protocolError,
                                              Response& response) override;
  kj::Promise<void> handleApplicationError(kj::Exception exception,
                                           kj::Maybe<Response&> response) override;
  void taskFailed(kj::Exception&& exception) override;

  std::variant<Call, Reply> check(kj::HttpMethod method, kj::StringPtr url,
                                  const kj::HttpHeaders& headers) const;
  kj::Promise<void> openEvents(const Call& call, Response& response);
  kj::Promise<void> send(Reply reply, Response& response);
  kj::HttpHeaders replyHeaders(const Reply& reply) const;

  Service& service_;
  Note note_;
  uint16_t port_;
  uint32_t open_ = 0;
  kj::HttpHeaderId authorization_, contentEncoding_, cacheControl_, sniffing_;
  kj::Own<kj::HttpHeaderTable> table_;
  kj::Own<kj::ConnectionReceiver> receiver_;
  kj::Own<kj::HttpServer> server_;
  kj::TaskSet tasks_;
};

}  // namespace obby::bridge
