#include "bridge/events.h"

#include "io/json_writer.h"

namespace obby::bridge {
namespace {

constexpr size_t kMaxIncoming = 4096;  // bytes; clients send only signs of life

class Relay {
 public:
  Relay(kj::Own<kj::WebSocket> socket, std::shared_ptr<Client> client, Service& service,
        uint64_t cursor)
      : socket_(kj::mv(socket)),
        client_(std::move(client)),
        service_(service),
        loop_(service.loop()),
        cursor_(cursor),
        nextPing_(loop_.now() + service.limits().pingSeconds) {
    client_->socketOpen = true;
    client_->dropSocket = false;
    client_->hold(cursor_);
  }
  ~Relay() {
    client_->socketOpen = false;
    client_->release();
  }
  KJ_DISALLOW_COPY(Relay);

  kj::Promise<void> run() {
    auto sending = send(service_.hello(*client_, cursor_), [this] { return sendMore(); });
    return sending.exclusiveJoin(receive()).exclusiveJoin(watch()).catch_([](kj::Exception&&) {});
  }

 private:
  kj::Promise<void> send(std::string text, kj::Function<kj::Promise<void>()> then) {
    text_ = std::move(text);
    return socket_->send(kj::ArrayPtr<const char>(text_.data(), text_.size())).then(kj::mv(then));
  }

  kj::Promise<void> sendMore() {
    client_->hold(cursor_);
    if (closing_) return socket_->close(kNormal, "bye");
    if (client_->dropSocket) return socket_->close(kSilent, "the client sent nothing for too long");
    if (!client_->ring().reaches(cursor_)) return sendReload();
    if (const Message* message = client_->ring().after(cursor_)) {
      cursor_ = message->number;
      return send(message->text, [this] { return sendMore(); });
    }
    if (client_->ending) return socket_->close(kGoingAway, "the bridge is shutting down");
    const double now = loop_.now();
    if (now >= nextPing_) {
      nextPing_ = now + service_.limits().pingSeconds;
      return send(R"({"type":"ping"})", [this] { return sendMore(); });
    }
    const auto left = uint64_t((nextPing_ - now) * 1000) + 1;
    return client_->whenWoken()
        .exclusiveJoin(loop_.timer.afterDelay(left * kj::MILLISECONDS))
        .then([this] { return sendMore(); });
  }

  kj::Promise<void> sendReload() {
    return send(io::JsonWriter()
                    .open('{')
                    .field("type", "reload")
                    .field("error", "messages after this cursor are no longer kept")
                    .field("cure", "get session and cursor from /v1/info, then ask again")
                    .finish(),
                [this] { return socket_->close(kReload, "reload"); });
  }

  // Any message from the client shows that it is still connected.
  kj::Promise<void> receive() {
    return socket_->receive(kMaxIncoming).then([this](kj::WebSocket::Message&& message) {
      client_->lastSeen = loop_.now();
      if (!message.is<kj::WebSocket::Close>()) return receive();
      closing_ = true;
      client_->wake();
      return kj::Promise<void>(kj::NEVER_DONE);  // sendMore replies and ends
    });
  }

  // A client that stops reading would block a message forever. watch() then ends the relay.
  kj::Promise<void> watch() {
    if (client_->dropSocket || closing_) return loop_.timer.afterDelay(1 * kj::SECONDS);
    return client_->whenWoken().then([this] { return watch(); });
  }

  kj::Own<kj::WebSocket> socket_;
  std::shared_ptr<Client> client_;
  Service& service_;
  Loop& loop_;
  uint64_t cursor_;
  double nextPing_;
  bool closing_ = false;
  std::string text_;  // text of the message being sent
};

}  // namespace

kj::Promise<void> sendEvents(kj::Own<kj::WebSocket> socket, std::shared_ptr<Client> client,
                             Service& service, uint64_t cursor) {
  auto relay = kj::heap<Relay>(kj::mv(socket), std::move(client), service, cursor);
  auto done = relay->run();
  return done.attach(kj::mv(relay));
}

}  // namespace obby::bridge
