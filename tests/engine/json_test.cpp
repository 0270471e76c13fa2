// JSON of HttpService.
#include <gtest/gtest.h>

#include "engine/place.h"

namespace obby::test {
namespace {

std::string json(const std::string& expression) {
  return resultOf("local http = game:GetService('HttpService')\nlocal result = " + expression);
}

TEST(Json, ValuesAreWritten) {
  const std::pair<const char*, const char*> cases[] = {
      {"{1, 'two', true}", R"([1,"two",true])"},
      {"{}", "[]"},
      {"{b = 2, a = {c = 0.5}}", R"({"a":{"c":0.5},"b":2})"},
      {R"('say "hi"\n')", R"("say \"hi\"\n")"},
      {"{part = workspace, gone = 0 / 0}", R"({"gone":null,"part":null})"}};
  for (const auto& [value, text] : cases)
    EXPECT_EQ(json("http:JSONEncode(" + std::string(value) + ")"), text) << value;
}

TEST(Json, TextsAreRead) {
  const std::pair<const char*, const char*> cases[] = {
      {R"(('[1, 2.5, -3e2]'))", "[1,2.5,-300]"},
      {R"((' { "a" : [ ] , "b" : null , "c" : { "d" : false } } '))",
       R"({"a":[],"c":{"d":false}})"},
      {R"(('"\\u00e4\\ud83d\\ude00\\n"'))", "\"\xc3\xa4\xf0\x9f\x98\x80\\n\""}};
  for (const auto& [text, again] : cases)
    EXPECT_EQ(json("http:JSONEncode(http:JSONDecode" + std::string(text) + ")"), again) << text;
}

TEST(Json, BrokenTextsAreErrors) {
  for (const char* text : {"", "{", "[1,]", "{\"a\"}", "[1] 2", "\"a", "tru", "1-2", "nan"})
    EXPECT_EQ(json("pcall(http.JSONDecode, http, '" + std::string(text) + "')"), "false") << text;
}

TEST(Json, DepthIsBounded) {
  EXPECT_EQ(json("pcall(http.JSONDecode, http, ('['):rep(1000) .. (']'):rep(1000))"), "false");
  EXPECT_EQ(json("pcall(function() local t = {} t.t = t return http:JSONEncode(t) end)"), "false");
}

}  // namespace
}  // namespace obby::test
