// The common part of HTTP servers on the loopback interface. It limits the number of connections,
// replies in bounded time, and survives clients that go away or send no HTTP.
#pragma once

#include <kj/compat/http.h>

#include <optional>
#include <string_view>

#include "loopback/event_loop.h"
#include "loopback/listener.h"
#include "loopback/reply.h"
#include "loopback/sender.h"

namespace obby::loopback {

struct ServerLimits {
  uint32_t connections = 64;  // max open at a time; further ones are closed
  double requestSeconds =
      60;  // max time for a request's head to arrive, and for a reply to be sent
  // Max bytes and seconds of a request's body that are read and dropped after an early reply.
  // Otherwise a client that is still sending would see a reset instead of the reply.
  size_t refusedBytes = 16 << 20;
  double refusedSeconds = 10;
};

// A service derives from this class and implements request().
class Server : protected kj::HttpService,
               private kj::HttpServerErrorHandler,
               private kj::TaskSet::ErrorHandler {
 public:
  // Accepts and serves connections. Ends only with an exception. Call it once.
  kj::Promise<void> run();
  // Resolves when the requests in progress, including WebSockets, have ended. Call it after run()
  // was dropped. Idle connections are closed.
  kj::Promise<void> drain() { return server_->drain(); }
  uint16_t port() const { return port_; }

 protected:
  Server(kj::LowLevelAsyncIoProvider& io, kj::Timer& timer, Listener listener, ServerLimits limits,
         Note note);

  // Returns the service's reply for a request that failed outside the service.
  virtual Reply failure(int status, const char* message, const char* cure) const = 0;

  kj::Promise<void> send(Reply reply, Response& response);
  kj::Promise<void> send(Reply reply, const kj::HttpHeaders& headers, Response& response);
  // Returns the headers of every reply: its type, no caching, no sniffing. More may be set.
  kj::HttpHeaders answerHeaders(const std::string& type) const;
  // Fails with a kj exception of type OVERLOADED if the write takes too long.
  kj::Promise<void> inTime(kj::Promise<void> written);
  void note(const std::string& text) const { note_(text); }
  const kj::HttpHeaderTable& headerTable() const { return *table_; }

  // These return a header of a request. The library treats an empty header with an id as absent,
  // but finds it by its name.
  static std::optional<std::string_view> valueOf(const kj::HttpHeaders& headers,
                                                 kj::HttpHeaderId id);
  static std::optional<std::string_view> valueOf(const kj::HttpHeaders& headers, const char* name);
  static void readHead(kj::HttpMethod method, kj::StringPtr url, const kj::HttpHeaders& headers,
                       Head& out);
  kj::HttpHeaderId authorization, contentEncoding;

 private:
  kj::Promise<void> handleClientProtocolError(kj::HttpHeaders::ProtocolError protocolError,
                                              Response& response) final;
  kj::Promise<void> handleApplicationError(kj::Exception exception,
                                           kj::Maybe<Response&> response) final;
  void taskFailed(kj::Exception&& exception) final;

  kj::Timer& timer_;
  Note note_;
  ServerLimits limits_;
  uint16_t port_;
  uint32_t open_ = 0;
  kj::HttpHeaderId cacheControl_, sniffing_;
  kj::Own<kj::HttpHeaderTable> table_;
  kj::Own<kj::ConnectionReceiver> receiver_;
  kj::Own<kj::HttpServer> server_;
  kj::TaskSet tasks_;
};

}  // namespace obby::loopback
