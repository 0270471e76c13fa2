// What any HTTP server on the loopback interface does: takes connections, not too many, answers in
// bounded time, and outlives clients that go away or send no HTTP.
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
  uint32_t connections = 64;   // open at a time; further ones are closed
  double requestSeconds = 60;  // until a request's head has come, and until an answer is taken
  // Of the body of a request that was answered before all of it had come, read (for so long at
  // most) and dropped: a client that is still sending would see a reset instead of the answer.
  size_t refusedBytes = 16 << 20;
  double refusedSeconds = 10;
};

// A service derives from it, and serves request().
class Server : protected kj::HttpService,
               private kj::HttpServerErrorHandler,
               private kj::TaskSet::ErrorHandler {
 public:
  // Accepts and serves connections; ends only with an exception. Once.
  kj::Promise<void> run();
  // To be called once run() was dropped: until requests that are being answered, WebSockets among
  // them, have ended. Connections that ask nothing are closed.
  kj::Promise<void> drain() { return server_->drain(); }
  uint16_t port() const { return port_; }

 protected:
  Server(kj::LowLevelAsyncIoProvider& io, kj::Timer& timer, Listener listener, ServerLimits limits,
         Note note);

  // How the service says that a request failed before or behind it.
  virtual Reply failure(int status, const char* message, const char* cure) const = 0;

  kj::Promise<void> send(Reply reply, Response& response);
  kj::Promise<void> send(Reply reply, const kj::HttpHeaders& headers, Response& response);
  // Those of every answer: its type, no cache, no guessing at the type. More may be set.
  kj::HttpHeaders answerHeaders(const std::string& type) const;
  // As a kj exception of type OVERLOADED if it takes too long.
  kj::Promise<void> inTime(kj::Promise<void> written);
  void note(const std::string& text) const { note_(text); }
  const kj::HttpHeaderTable& headerTable() const { return *table_; }

  // Of a request. The library takes an empty header with an id for an absent one; by its name it is
  // found.
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
