// The requests that are accepted, and their meaning.
#include "bridge/request.h"

#include <gtest/gtest.h>

namespace obby::bridge {
namespace {

RequestHead honest(const char* method, const char* target) {
  RequestHead head;
  head.method = method;
  head.target = target;
  head.host = "127.0.0.1:34990";
  head.authorization = "Bearer right";
  if (head.method == "POST") head.contentType = "application/json";
  return head;
}

Access access() {
  return {34990, true, [](std::string_view token) { return token == "right" ? 3 : -1; }};
}

int statusOf(const std::variant<Call, Reply>& checked) {
  const Reply* reply = std::get_if<Reply>(&checked);
  return reply ? reply->status : 0;
}

int check(const RequestHead& head) { return statusOf(checkRequest(head, access())); }

TEST(Request, valid_requests_are_accepted_with_their_client) {
  const auto checked = checkRequest(honest("GET", "/v1/jobs/j12?cursor=7&wait=20"), access());
  const Call& call = std::get<Call>(checked);
  EXPECT_EQ(call.endpoint, Endpoint::getJob);
  EXPECT_EQ(call.id, "j12");
  EXPECT_EQ(call.cursor, 7u);
  EXPECT_EQ(call.wait, 20);
  EXPECT_EQ(call.client, 3);
}

TEST(Request, hosts_must_be_the_loopback_with_the_port) {
  for (const char* host :
       {"127.0.0.1:34990", "localhost:34990", "LocalHost:34990", "[::1]:34990"}) {
    RequestHead head = honest("GET", "/v1/info");
    head.host = host;
    EXPECT_EQ(check(head), 0) << host;
  }
  for (const char* host : {"", "127.0.0.1", "localhost", "127.0.0.1:34991", "example.org:34990",
                           "127.0.0.1:34990.example.org", " 127.0.0.1:34990", "0.0.0.0:34990",
                           "127.0.0.2:34990", "127.0.0.1:034990"}) {
    RequestHead head = honest("GET", "/v1/info");
    head.host = host;
    EXPECT_EQ(check(head), 421) << host;
  }
}

TEST(Request, any_origin_header_is_refused_even_if_empty) {
  for (const char* origin : {"", "null", "http://127.0.0.1:34990", "file://"}) {
    RequestHead head = honest("GET", "/v1/info");
    head.origin = origin;
    EXPECT_EQ(check(head), 403) << origin;
  }
  RequestHead head = honest("GET", "/v1/info");
  head.fetchSite = "none";
  EXPECT_EQ(check(head), 403);
}

TEST(Request, unpaired_clients_may_only_get_info_and_pair) {
  for (const char* target : {"/v1/jobs/j1", "/v1/levels/00000000000000000000000000000000",
                             "/v1/events", "/v1/nothing", "/"}) {
    RequestHead head = honest("GET", target);
    head.authorization.reset();
    EXPECT_EQ(check(head), 401) << target;
  }
  RequestHead head = honest("GET", "/v1/info");
  head.authorization.reset();
  EXPECT_EQ(check(head), 0);
  head.authorization = "Bearer wrong";  // reported as a stale token
  EXPECT_EQ(check(head), 401);
}

TEST(Request, without_tokens_every_request_is_the_first_clients) {
  RequestHead head = honest("GET", "/v1/jobs/j1");
  head.authorization.reset();
  Access open = access();
  open.needToken = false;
  EXPECT_EQ(std::get<Call>(checkRequest(head, open)).client, 0);
}

TEST(Request, content_types_are_those_of_the_endpoint) {
  for (const char* type : {"application/json", "Application/JSON; charset=utf-8"}) {
    RequestHead head = honest("POST", "/v1/jobs");
    head.contentType = type;
    EXPECT_EQ(check(head), 0) << type;
  }
  for (const char* type : {"text/plain", "application/x-ndjson", "", "application/jsonx"}) {
    RequestHead head = honest("POST", "/v1/jobs");
    head.contentType = type;
    EXPECT_EQ(check(head), 415) << type;
  }
  RequestHead level = honest("POST", "/v1/levels");
  EXPECT_EQ(check(level), 415);
  level.contentType = "application/octet-stream";
  level.encoding = "gzip";
  EXPECT_TRUE(std::get<Call>(checkRequest(level, access())).gzip);
  level.encoding = "br";
  EXPECT_EQ(check(level), 415);
}

TEST(Request, a_code_is_plain_text) {
  RequestHead head = honest("POST", "/v1/pair");
  EXPECT_EQ(check(head), 0);
  head.encoding = "identity";
  EXPECT_EQ(check(head), 0);
  head.encoding = "gzip";
  EXPECT_EQ(check(head), 415);
  head.authorization.reset();
  EXPECT_EQ(check(head), 415);
}

TEST(Request, only_events_use_a_websocket) {
  RequestHead head = honest("GET", "/v1/events");
  EXPECT_EQ(check(head), 426);
  head.upgrade = head.webSocket = true;
  head.webSocketVersion = "13";
  EXPECT_EQ(check(head), 426);
  head.webSocketKey = "dGhlIHNhbXBsZSBub25jZQ==";
  EXPECT_EQ(check(head), 0);
  head.target = "/v1/info";
  EXPECT_EQ(check(head), 400);
}

TEST(Request, ids_and_parameters_are_well_formed) {
  EXPECT_TRUE(isJobId("j1"));
  EXPECT_FALSE(isJobId("j"));
  EXPECT_FALSE(isJobId("j12345678901234567"));
  EXPECT_FALSE(isJobId("j1/.."));
  EXPECT_TRUE(isLevelId("0123456789abcdef0123456789abcdef"));
  EXPECT_FALSE(isLevelId("0123456789ABCDEF0123456789abcdef"));
  for (const char* target :
       {"/v1/jobs/j1?cursor=", "/v1/jobs/j1?cursor=-1", "/v1/jobs/j1?cursor=9007199254740992",
        "/v1/jobs/j1?wait=3601", "/v1/jobs/j1?wait=1&wait=1", "/v1/jobs/j1?cursor", "/v1/info?",
        "/v1/jobs/j1?=1", "/v1/info?cursor=1", "/v1/jobs/j1?session=zz", "/v1/jobs/j1?&cursor=1"}) {
    const int expected = std::string_view(target) == "/v1/info?" ? 0 : 400;
    EXPECT_EQ(statusOf(route("GET", target)), expected) << target;
  }
  EXPECT_EQ(statusOf(route("GET", "/v1/jobs/j1?cursor=9007199254740991")), 0);
  const std::string level = "/v1/levels/0123456789abcdef0123456789abcdef";
  EXPECT_FALSE(std::get<Call>(route("GET", level)).moving);
  EXPECT_TRUE(std::get<Call>(route("GET", level + "?parts=moving")).moving);
  for (const char* parameter : {"?parts=", "?parts=all", "?parts=moving&parts=moving", "?wait=1"}) {
    EXPECT_EQ(statusOf(route("GET", level + parameter)), 400) << parameter;
  }
}

}  // namespace
}  // namespace obby::bridge
