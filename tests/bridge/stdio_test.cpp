// Requests and answers as lines.
#include <gtest/gtest.h>

#include "bridge/stdio_request.h"

namespace obby::bridge {
namespace {

TEST(StdioRequest, bodies_are_json_text_or_base64) {
  const auto json = parseStdioRequest(
      "{\"id\":7,\"method\":\"POST\",\"path\":\"/v1/jobs\",\"body\":{\"a\":[1.50]}}");
  EXPECT_EQ(json.id, "7");
  EXPECT_EQ(std::get<Call>(json.call).endpoint, Endpoint::putJob);
  EXPECT_EQ(json.body, "{\"a\":[1.50]}");
  const auto text =
      parseStdioRequest("{\"method\":\"POST\",\"path\":\"/v1/levels\",\"text\":\"a\\nb\"}");
  EXPECT_EQ(text.id, "null");
  EXPECT_EQ(text.body, "a\nb");
  const auto bytes =
      parseStdioRequest("{\"method\":\"POST\",\"path\":\"/v1/levels\",\"base64\":\"AAH/\"}");
  EXPECT_EQ(bytes.body, std::string("\0\1\xff", 3));
}

TEST(StdioRequest, errors_are_answered_under_the_requests_id) {
  for (const char* line : {"{\"id\":\"x\",\"method\":\"GET\",\"path\":\"/nowhere\"}",
                           "{\"id\":\"x\",\"method\":\"GET\",\"path\":\"/v1/info\",\"speed\":1}",
                           "{\"id\":\"x\",\"path\":\"/v1/info\"}",
                           "{\"id\":\"x\",\"path\":\"/v1/info\",\"body\":1,\"text\":\"\"}",
                           "{\"id\":\"x\",\"path\":\"/v1/info\",\"base64\":\"!\"}"}) {
    const auto request = parseStdioRequest(line);
    EXPECT_EQ(request.id, "\"x\"") << line;
    EXPECT_TRUE(std::holds_alternative<Reply>(request.call)) << line;
  }
  for (const char* line : {"", "x", "[1]", "{\"id\":{}}"}) {
    const auto request = parseStdioRequest(line);
    EXPECT_EQ(request.id, "null") << line;
    EXPECT_GE(std::get<Reply>(request.call).status, 400) << line;
  }
}

TEST(StdioRequest, answers_are_one_line) {
  EXPECT_EQ(stdioReply("1", {200, "{\"a\":1}"}), "{\"id\":1,\"status\":200,\"body\":{\"a\":1}}");
  EXPECT_EQ(stdioReply("\"b\"", {200, "x\ny", "application/x-ndjson"}),
            "{\"id\":\"b\",\"status\":200,\"text\":\"x\\ny\"}");
}

}  // namespace
}  // namespace obby::bridge
