// The requests that the live page's server accepts.
#include "view/live_request.h"

#include <gtest/gtest.h>

#include <string>

namespace obby::view {
namespace {

constexpr uint16_t kPort = 8080;
const std::string kToken(64, 'a');

LiveHead honest(std::string_view target) {
  LiveHead head;
  head.method = "GET";
  head.target = target;
  head.host = "127.0.0.1:8080";
  head.fetchSite = "same-origin";
  return head;
}

std::string with(const char* path, const std::string& token = kToken) {
  return std::string(path) + "?token=" + token;
}

// Returns the status of the refusal, or 0 if the request is accepted.
int statusOf(const LiveHead& head) {
  const auto checked = checkLiveRequest(head, kPort, kToken);
  const auto* reply = std::get_if<loopback::Reply>(&checked);
  return reply ? reply->status : 0;
}

TEST(LiveRequest, valid_requests_are_accepted) {
  for (const char* path : {"/", "/data", "/events"}) {
    const std::string target = with(path);
    EXPECT_EQ(statusOf(honest(target)), 0) << path;
  }
  const std::string target = with("/data") + "&from=17";
  const auto checked = checkLiveRequest(honest(target), kPort, kToken);
  EXPECT_EQ(std::get<LiveCall>(checked).route, LiveRoute::data);
  EXPECT_EQ(std::get<LiveCall>(checked).from, 17u);
}

TEST(LiveRequest, without_the_token_nothing_is_revealed) {
  std::string nearly = kToken;
  nearly.back() = 'b';
  for (const char* path : {"/", "/data", "/events", "/nothing", "/../etc/passwd"}) {
    for (const std::string& target :
         {std::string(path), with(path, ""), with(path, nearly), with(path, kToken + "a"),
          with(path, kToken.substr(1)), with(path) + "&token=" + kToken,
          std::string(path) + "?Token=" + kToken}) {
      LiveHead head = honest(target);
      EXPECT_EQ(statusOf(head), 403) << target;
      head.method = "POST";
      EXPECT_EQ(statusOf(head), 403) << target;
    }
  }
}

TEST(LiveRequest, other_hosts_are_refused) {
  const std::string target = with("/");
  for (const char* host : {"", "127.0.0.1", "127.0.0.1:8081", "evil.example:8080"}) {
    LiveHead head = honest(target);
    head.host = host;
    EXPECT_EQ(statusOf(head), 421) << host;
  }
  LiveHead head = honest(target);
  head.host.reset();
  EXPECT_EQ(statusOf(head), 421);
}

TEST(LiveRequest, other_pages_may_only_link_here) {
  const std::string page = with("/"), data = with("/data"), events = with("/events");
  for (const std::string& target : {page, data, events}) {
    for (const char* origin : {"", "null", "http://evil.example", "http://127.0.0.1:8081"}) {
      LiveHead head = honest(target);
      head.origin = origin;
      EXPECT_EQ(statusOf(head), 403) << target << origin;
    }
    LiveHead head = honest(target);
    head.origin = "http://127.0.0.1:8080";
    EXPECT_EQ(statusOf(head), 0) << target;
    for (const char* site : {"cross-site", "same-site", ""}) {
      head = honest(target);
      head.fetchSite = site;
      EXPECT_EQ(statusOf(head), 403) << target << site;
      head.fetchMode = "navigate";
      EXPECT_EQ(statusOf(head), target == page ? 0 : 403) << target << site;
    }
    head = honest(target);
    head.fetchSite.reset();  // old browsers and other programs omit this header
    EXPECT_EQ(statusOf(head), 0);
  }
}

TEST(LiveRequest, other_methods_paths_and_parameters_are_refused) {
  const std::string page = with("/"), data = with("/data");
  for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "HEAD"}) {
    LiveHead head = honest(page);
    head.method = method;
    EXPECT_EQ(statusOf(head), 405) << method;
  }
  for (const char* path : {"/x", "//", "/data/", "/index.html", "", "http://127.0.0.1:8080/"}) {
    const std::string target = with(path);
    EXPECT_EQ(statusOf(honest(target)), 404) << path;
  }
  for (const char* more : {"&from=-1", "&from=1e3", "&from=", "&from=9007199254740992", "&x=1",
                           "&from=1&from=2", "&from=1&x=2"}) {
    const std::string target = data + more;
    EXPECT_EQ(statusOf(honest(target)), 400) << more;
  }
  const std::string target = page + "&from=1";
  EXPECT_EQ(statusOf(honest(target)), 400);
  const std::string endless = data + "&from=" + std::string(100000, '1');
  EXPECT_EQ(statusOf(honest(endless)), 400);
}

}  // namespace
}  // namespace obby::view
