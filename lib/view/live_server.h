// Serves the live page, its data and its events over HTTP. It runs on the event loop's thread,
// which also owns the data.
#pragma once

#include <string>

#include "loopback/server.h"
#include "view/live_data.h"

namespace obby::view {

class LiveServer final : public loopback::Server {
 public:
  LiveServer(kj::AsyncIoContext& io, loopback::Listener listener, const LiveData& data,
             std::string page, loopback::Note note);

  // Returns the address of the page, including the token that requests must carry.
  std::string address() const;
  // Returns the seconds since a page was last connected or sent a request; 0 while a page is
  // connected.
  double quietFor() const;

 private:
  kj::Promise<void> request(kj::HttpMethod method, kj::StringPtr url,
                            const kj::HttpHeaders& headers, kj::AsyncInputStream& requestBody,
                            Response& response) override;
  loopback::Reply failure(int status, const char* message, const char* cure) const override;
  kj::HttpHeaders pageHeaders(const std::string& type) const;
  kj::Promise<void> sendEvents(Response& response);

  kj::Timer& timer_;
  const LiveData& data_;
  std::string page_, token_;
  uint32_t open_ = 0;  // pages that receive events
  kj::TimePoint lastSeen_;
};

}  // namespace obby::view
