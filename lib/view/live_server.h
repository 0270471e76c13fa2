// Serves the live page, its data and its events over HTTP. Runs on the event loop's thread, which
// the data belongs to, too.
#pragma once

#include <string>

#include "loopback/server.h"
#include "view/live_data.h"

namespace obby::view {

class LiveServer final : public loopback::Server {
 public:
  LiveServer(kj::AsyncIoContext& io, loopback::Listener listener, const LiveData& data,
             std::string page, loopback::Note note);

  // That opens the page: with the token, which whoever asks must know.
  std::string address() const;
  // Seconds since a page was last there, or asked for something; 0: one is there.
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
  uint32_t open_ = 0;  // pages that listen
  kj::TimePoint lastSeen_;
};

}  // namespace obby::view
