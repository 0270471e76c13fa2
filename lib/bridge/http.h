// The service over HTTP and WebSockets on the loopback interface.
#pragma once

#include "bridge/service.h"
#include "loopback/server.h"

namespace obby::bridge {

class HttpFront final : public loopback::Server {
 public:
  HttpFront(Service& service, loopback::Listener listener, loopback::Note note);

 private:
  kj::Promise<void> request(kj::HttpMethod method, kj::StringPtr url,
                            const kj::HttpHeaders& headers, kj::AsyncInputStream& requestBody,
                            Response& response) override;
  Reply failure(int status, const char* message, const char* cure) const override;

  std::variant<Call, Reply> check(kj::HttpMethod method, kj::StringPtr url,
                                  const kj::HttpHeaders& headers) const;
  kj::Promise<void> openEvents(const Call& call, Response& response);

  Service& service_;
};

}  // namespace obby::bridge
