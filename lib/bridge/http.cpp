#include "bridge/http.h"

#include <fmt/format.h>

#include "bridge/body.h"
#include "bridge/events.h"

namespace obby::bridge {

HttpFront::HttpFront(Service& service, loopback::Listener listener, loopback::Note note)
    : Server(service.loop().io, service.loop().timer, std::move(listener),
             {service.limits().connections, service.limits().requestSeconds}, std::move(note)),
      service_(service) {}

Reply HttpFront::failure(int status, const char* message, const char* cure) const {
  return refuse(status, message, cure);
}

std::variant<Call, Reply> HttpFront::check(kj::HttpMethod method, kj::StringPtr url,
                                           const kj::HttpHeaders& headers) const {
  RequestHead head;
  readHead(method, url, headers, head);
  head.authorization = valueOf(headers, authorization);
  head.contentType = valueOf(headers, kj::HttpHeaderId::CONTENT_TYPE);
  head.encoding = valueOf(headers, contentEncoding);
  head.upgrade = valueOf(headers, kj::HttpHeaderId::UPGRADE).has_value();
  head.webSocket = headers.isWebSocket();
  head.webSocketVersion = valueOf(headers, kj::HttpHeaderId::SEC_WEBSOCKET_VERSION);
  head.webSocketKey = valueOf(headers, kj::HttpHeaderId::SEC_WEBSOCKET_KEY);
  return checkRequest(head, {port(), service_.needToken(),
                             [this](std::string_view token) { return service_.clientOf(token); }});
}

kj::Promise<void> HttpFront::request(kj::HttpMethod method, kj::StringPtr url,
                                     const kj::HttpHeaders& headers,
                                     kj::AsyncInputStream& requestBody, Response& response) {
  auto checked = check(method, url, headers);
  if (Reply* refusal = std::get_if<Reply>(&checked)) {
    note(fmt::format("a request was refused with {}: {}", refusal->status, refusal->body));
    return send(std::move(*refusal), response);
  }
  Call call = std::get<Call>(std::move(checked));
  if (call.endpoint == Endpoint::events) return openEvents(call, response);
  if (call.content == Content::none) {
    return service_.handle(call, {}).then(
        [this, &response](Reply reply) { return send(std::move(reply), response); });
  }
  if (auto closed = service_.closedTo(call)) return send(*std::move(closed), response);
  return readBody(requestBody, call, service_.limits(), service_.loop().timer)
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
  auto socket = response.acceptWebSocket(kj::HttpHeaders(headerTable()));
  return sendEvents(kj::mv(socket), std::move(client), service_, cursor);
}

}  // namespace obby::bridge
