#include "io/json_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace obby::io {
namespace {

TEST(JsonWriter, SetsCommasInNestedObjectsAndArrays) {
  JsonWriter json;
  json.open('{').field("a", 1).field("b", true).key("c").open('[').value(0.5f).null().close();
  json.key("d").open('{').close().key("e").open('[').open('[').close().open('[').close().close();
  json.close();
  EXPECT_EQ(json.text(), R"({"a":1,"b":true,"c":[0.5,null],"d":{},"e":[[],[]]})");
}

TEST(JsonWriter, FinishClosesAllBracketsAndStartsAgain) {
  JsonWriter json;
  EXPECT_EQ(json.open('{').key("a").open('[').open('{').field("b", "c").finish(),
            R"({"a":[{"b":"c"}]})");
  EXPECT_EQ(json.value(2).finish(), "2");
}

TEST(JsonWriter, EscapesTextAndNames) {
  JsonWriter json;
  json.open('{').field("\"", "\\ \n \r \t \x01 \x7f / caf\xc3\xa9 \xe2\x80\xa8");
  EXPECT_EQ(json.finish(),
            "{\"\\\"\":\"\\\\ \\n \\r \\t \\u0001 \\u007f / caf\xc3\xa9 \xe2\x80\xa8\"}");
  EXPECT_EQ(json.value(std::string_view("a\0b", 3)).finish(), R"("a\u0000b")");
}

TEST(JsonWriter, ReplacesBytesThatAreNotUtf8) {
  EXPECT_EQ(JsonWriter().value("a\xff\xc3z\xe2\x80").finish(),
            "\"a\xef\xbf\xbd\xef\xbf\xbdz\xef\xbf\xbd\xef\xbf\xbd\"");
}

TEST(JsonWriter, NumbersParseToTheSameBits) {
  JsonWriter json;
  json.open('[').value(0.1f).value(0.1).value(1e300).value(5.0).value(-0.0).value(-0.0f).value(0.f);
  json.value(INT64_MIN).value(UINT64_MAX).value(uint8_t(7)).value(-1);
  EXPECT_EQ(json.finish(),
            "[0.1,0.1,1e+300,5,-0.0,-0.0,0,-9223372036854775808,18446744073709551615,7,-1]");
}

TEST(JsonWriter, NumbersThatAreNotFiniteAreNull) {
  EXPECT_EQ(JsonWriter().open('[').value(std::nanf("")).value(double(INFINITY)).finish(),
            "[null,null]");
}

TEST(JsonWriter, ListsValuesAndTakesJsonAsItIs) {
  JsonWriter json;
  json.open('{').key("a").list(std::vector<std::string>{"x", "\""}).key("b").raw("{\"c\": 1}");
  EXPECT_EQ(json.key("d").list(std::vector<int>{}).finish(),
            R"({"a":["x","\""],"b":{"c": 1},"d":[]})");
}

TEST(JsonWriter, PacksNumbersAsBase64) {
  EXPECT_EQ(JsonWriter().packed(std::vector<uint8_t>{1, 2, 3, 255}).finish(), R"("AQID/w==")");
  EXPECT_EQ(JsonWriter().packed(std::vector<float>{1.0f}).finish(), R"("AACAPw==")");
  EXPECT_EQ(JsonWriter().packed(std::vector<uint16_t>(300)).finish(),
            '"' + std::string(800, 'A') + '"');
}

}  // namespace
}  // namespace obby::io
