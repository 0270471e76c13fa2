// The meaning of JSON lines, and the errors for invalid ones.
#include "io/json_codec.h"

#include <gtest/gtest.h>

namespace obby::io {
namespace {

std::string jsonCodecErrorOf(const std::string& line) {
  auto record = recordFromJson(line);
  return record ? "no error" : record.error().text();
}

std::string normal(const std::string& line) {
  auto record = recordFromJson(line);
  if (!record) return record.error().text();
  auto json = recordToJson(record->reader());
  return json ? *json : json.error().text();
}

struct JsonCodecCase {
  std::string line, expected;
};

TEST(JsonErrors, StateThePathTheExpectedAndTheFoundValue) {
  const JsonCodecCase cases[] = {
      {R"({"type":"level","parts":[{},{"size":[1,2]}]})",
       "parts[1].size: expected 3 numbers, found an array of 2"},
      {R"({"type":"level","parts":[{"size":[1,2,"3"]}]})",
       "parts[0].size[2]: expected a number, found text \"3\""},
      {R"({"type":"level","parts":[{"size":{"x":1}}]})",
       "parts[0].size: expected 3 numbers, found an object"},
      {R"({"type":"level","parts":{}})", "parts: expected an array, found an empty object"},
      {R"({"type":"level","parts":[3]})",
       "parts[0]: expected an object such as {\"name\":\"...\"}, found 3"},
      {R"({"type":"level","parts":[{"kill":true}]})",
       "parts[0].kill: expected an object such as {\"damage\":100}, found true"},
      {R"({"type":"level","parts":[{"kill":[1]}]})",
       "parts[0].kill: expected an object such as {\"damage\":100}, found an array of 1"},
      {R"({"type":"level","parts":[{"seat":true}]})",
       "parts[0].seat: expected an object such as {}, found true"},
      {R"({"type":"level","parts":[{"conveyor":[0,0,4]}]})",
       "parts[0].conveyor: expected an object such as {\"velocity\":[8,0,0]}, found an array of 3"},
      {R"({"type":"query","goal":"Finish"})",
       "goal: expected an object such as {\"part\":\"Finish\"}, found text \"Finish\""},
      {R"({"type":"query","waypoints":["Gate"]})",
       "waypoints[0]: expected an object such as {\"region\":{\"part\":\"Finish\"}}, found text "
       "\"Gate\""},
      {R"({"type":"level","parts":[{"rotation":[0,90,0]}]})",
       "parts[0].rotation: expected 4 numbers, found an array of 3 (a rotation is a quaternion "
       "[x,y,z,w]: [0,0.7071,0,0.7071] turns 90 degrees about Y)"},
      {R"({"type":"level","name":7})", "name: expected text, found 7"},
      {R"({"type":"level","parts":[{"solid":1}]})",
       "parts[0].solid: expected true or false, found 1"},
      {R"({"type":"level","parts":[{"tags":["a",-2]}]})",
       "parts[0].tags[1]: expected text, found -2"},
      {R"({"type":"level","parts":[{"shape":"bal"}]})",
       "parts[0].shape: expected one of block, ball, cylinder, wedge, cornerWedge, truss, hull, "
       "found text \"bal\" (did you mean \"ball\"?)"},
      {R"({"type":"level","parts":[{"color":[1,2,256]}]})",
       "parts[0].color[2]: expected a whole number from 0 to 255, found 256"},
      {R"({"type":"level","parts":[{"color":[1,2.5,3]}]})",
       "parts[0].color[1]: expected a whole number from 0 to 255, found 2.5"},
      {R"({"type":"query","maxJumps":-2147483649})",
       "maxJumps: expected a whole number from -2147483648 to 2147483647, found -2147483649"},
      {R"({"type":"level","physics":{"gravity":-1}})",
       "physics.gravity: expected a number from 0 to 2000, found -1"},
      {R"({"type":"level","physics":{"controlRate":9}})",
       "physics.controlRate: expected a whole number from 10 to 480, found 9"},
      {R"({"type":"query","timeLimit":1e39})", "timeLimit: the number is too large: 1e39"},
      {R"({"type":"level","physics":{"gravity":1e39}})",
       "physics.gravity: the number is too large: 1e39"},
      {R"({"type":"query","timeLimit":1e999})", "column 33: the number is too large"},
      {R"({"type":"query","timeLimit":-Infinity})",
       "column 30: expected a finite number, found -Infinity"},
      {R"({"type":"query","timeLimit":nan})", "column 30: expected a finite number, found nan"},
      {R"({"type":"result","steps":1.5})",
       "steps: expected a whole number from 0 to 18446744073709551615 in quotes, found 1.5"},
      {R"({"type":"result","steps":9007199254740993})",
       "steps: expected a whole number from 0 to 18446744073709551615 in quotes, found "
       "9007199254740993"},
      {R"({"type":"result","steps":"18446744073709551616"})",
       "steps: expected a whole number from 0 to 18446744073709551615 in quotes, found text "
       "\"18446744073709551616\""},
      {R"({"type":"result","steps":"-1"})",
       "steps: expected a whole number from 0 to 18446744073709551615 in quotes, found text "
       "\"-1\""},
      {R"({"type":"result","steps":" 1"})",
       "steps: expected a whole number from 0 to 18446744073709551615 in quotes, found text \" "
       "1\""},
      {R"({"type":"query","id":"a","id":"b"})", "id: the field is given twice"},
      {R"({"type":"query","id":"a","type":"level"})", "type: the field is given twice"},
      {R"({"type":"queri"})",
       "type: expected one of header, level, query, progress, trajectory, result, recording, "
       "params, metrics, end, found \"queri\" (did you mean \"query\"?)"},
      {R"({"type":3})",
       "type: expected one of header, level, query, progress, trajectory, result, recording, "
       "params, metrics, end, found 3"},
      {R"({"name":"x"})",
       "type: expected one of header, level, query, progress, trajectory, result, recording, "
       "params, metrics, end, found none"},
      {R"([1,2])", "expected a record such as {\"type\":\"level\"}, found an array of 2"},
      {R"("level")", "expected a record such as {\"type\":\"level\"}, found text \"level\""},
      {R"({"type":"level"} {)", "column 18: expected the end of the text, found '{'"},
      {R"({"type":"level",})", "column 17: expected a string in double quotes, found '}'"},
      {R"({"type":"level","name":"Banana",})",
       "column 33: expected a string in double quotes, found '}'"},
      {R"({"type":"level","name":"\NaN"})",
       "column 26: expected JSON, found invalid string: forbidden character after backslash"},
      {R"({type:"level"})",
       "column 3: expected a string in double quotes, found text that is not JSON"},
      {R"({"type":"le)", "column 12: the text ends in the middle of a value"},
      {"{\"type\":\"level\",\"name\":\"\xff\"}",
       "column 25: expected JSON, found invalid string: ill-formed UTF-8 byte"},
      {"{\"type\":\"level\",\"name\":\"\\ud800\"}",
       "column 31: expected JSON, found invalid string: surrogate U+D800..U+DBFF must be followed "
       "by "
       "U+DC00..U+DFFF"},
  };
  for (const JsonCodecCase& c : cases) EXPECT_EQ(jsonCodecErrorOf(c.line), c.expected) << c.line;
}

TEST(JsonLines, AQueryKeepsItsTitle) {
  const std::string line = R"({"type":"query","id":"stage1","title":"Stage 1: 'A' to 'B'"})";
  EXPECT_EQ(recordFromJson(line)->reader().getQuery().getTitle(), "Stage 1: 'A' to 'B'");
  EXPECT_EQ(normal(line), R"({"type":"query","id":"stage1","title":"Stage 1: 'A' to 'B'"})");
}

TEST(JsonErrors, NothingMayFollowAZeroByte) {
  const std::string line = R"({"type":"query"})";
  EXPECT_EQ(jsonCodecErrorOf(line), "no error");
  EXPECT_EQ(jsonCodecErrorOf(line + '\0'), "column 17: expected JSON, found a zero byte");
  EXPECT_EQ(jsonCodecErrorOf(line + '\0' + "junk"), "column 17: expected JSON, found a zero byte");
}

TEST(JsonErrors, NestingIsBounded) {
  for (int depth : {63, 64, 65, 1000, 1000000}) {
    const std::string open(size_t(depth - 1), '['), shut(size_t(depth - 1), ']');
    const std::string line = "{\"type\":\"level\",\"future\":" + open + shut + "}";
    EXPECT_EQ(jsonCodecErrorOf(line),
              depth <= 64 ? "no error" : "values are nested deeper than 64 levels")
        << depth;
  }
}

TEST(JsonErrors, ARecordOfBillionsOfBytesIsRefusedBeforeItIsBuilt) {
  std::string line = "{\"type\":\"level\",\"parts\":[{}";
  for (int i = 0; i < 1800000; i++)
    line += ",{}";  // each item takes 19 words in memory, but three bytes here
  EXPECT_EQ(jsonCodecErrorOf(line + "]}"),
            "parts: the record is larger than the maximum of 256 MiB");
}

TEST(JsonMeaning, LenientInputHasOneNormalForm) {
  const JsonCodecCase cases[] = {
      {R"({"type":"query","goal":[]})", R"({"type":"query","goal":{}})"},
      {R"({"goal":{},"type":"query"})", R"({"type":"query","goal":{}})"},
      {R"({"type":"query","goal":null,"id":null,"maxJumps":null})", R"({"type":"query"})"},
      {R"({"type":"query","maxJumps":3.0,"timeLimit":8.50})",
       R"({"type":"query","maxJumps":3,"timeLimit":8.5})"},
      {R"({"type":"result","steps":9007199254740992,"seed":7,"cells":"18446744073709551615"})",
       R"({"type":"result","query":"","verdict":"solved","solutions":0,"ticks":0,"jumps":0,)"
       R"("steps":"9007199254740992","cells":"18446744073709551615","seed":"7"})"},
      {R"({"type":"end"})", R"({"type":"end","status":"complete","records":"0"})"},
      {R"({"type":"level","parts":[{"kill":{"damage":100}}],"spawns":[]})",
       R"({"type":"level","parts":[{"kill":{}}]})"},
      {R"({"type":"level","parts":[{"size":[4,1,2],"rotation":[0,0,0,1],"color":[163,162,165]}]})",
       R"({"type":"level","parts":[{}]})"},
      {R"({"type":"level","parts":[{"size":[0,0,0]}]})",
       R"({"type":"level","parts":[{"size":[0,0,0]}]})"},
      {R"({"type":"level","tomorrow":{"deep":[1]},"parts":[{"also":1}]})",
       R"({"type":"level","parts":[{}]})"},
      {R"({"type":"level","name":"\u00e9\u0000\u20ac\ud83d\ude00\u007f\u001f\/"})",
       "{\"type\":\"level\",\"name\":\"\xc3\xa9\\u0000\xe2\x82\xac\xf0\x9f\x98\x80\\u007f\\u001f/"
       "\"}"},
      {R"({"type":"query","timeLimit":-0.0})", R"({"type":"query","timeLimit":-0.0})"},
      {R"({"type":"query","timeLimit":1e-60})", R"({"type":"query"})"},
      {R"({"type":"query","timeLimit":16777217})", R"({"type":"query","timeLimit":16777216})"},
      {R"({"type":"level","parts":[{"hulls":[{"vertices":[[0,0,0],[1,0,0]]}]}]})",
       R"({"type":"level","parts":[{"hulls":[{"vertices":[[0,0,0],[1,0,0]]}]}]})"},
  };
  for (const JsonCodecCase& c : cases) {
    EXPECT_EQ(normal(c.line), c.expected);
    EXPECT_EQ(normal(c.expected), c.expected);
  }
}

TEST(JsonMeaning, PresenceOfAnEmptyStructIsKept) {
  auto record = recordFromJson(R"({"type":"level","parts":[{"kill":{}},{}]})");
  ASSERT_TRUE(record);
  const auto parts = record->reader().getLevel().getParts();
  EXPECT_TRUE(parts[0].hasKill());
  EXPECT_FALSE(parts[1].hasKill());
  EXPECT_FALSE(parts[0].hasConveyor());
}

TEST(JsonMeaning, AnUnknownKindIsNotAnError) {
  auto unknown = recordFromJsonIfKnown(R"({"type":"weather","rain":[1,{"x":2}]})");
  ASSERT_TRUE(unknown);
  EXPECT_FALSE(unknown->has_value());
}

// Misspelt fields are reported. Private notes and fields of later versions are not.
TEST(JsonMeaning, MisspeltFieldsAreReported) {
  std::vector<Error> slips;
  const auto record = recordFromJsonIfKnown(
      R"({"type":"query","id":"q","maxJump":2,"reviewedBy":"Ada","goal":{"positon":[1,2,3]}})",
      &slips);
  ASSERT_TRUE(record && *record);
  ASSERT_EQ(slips.size(), 2u);
  EXPECT_EQ(slips[0].text(), "maxJump: unknown field, ignored (did you mean \"maxJumps\"?)");
  EXPECT_EQ(slips[1].path, "goal.positon");
}

TEST(JsonMeaning, TheSearchForMisspeltFieldsIsBounded) {
  const auto countMisspelt = [](const std::string& notes) {
    std::vector<Error> misspelt;
    EXPECT_TRUE(recordFromJsonIfKnown("{\"type\":\"level\"" + notes + ",\"part\":[]}", &misspelt));
    return misspelt.size();
  };
  std::string same, different;
  for (int i = 0; i < 2000; i++) {
    same += ",\"a note of mine\":1";
    different += ",\"a note of mine, number " + std::to_string(i) + "\":1";
  }
  EXPECT_EQ(countMisspelt(same), 1u);
  EXPECT_EQ(countMisspelt(different), 0u);
}

TEST(JsonMeaning, MisspeltKindsAreErrors) {
  std::vector<Error> slips;
  auto unknown = recordFromJsonIfKnown(R"({"type":"weather","id":"q"})", &slips);
  ASSERT_TRUE(unknown);
  EXPECT_TRUE(slips.empty());
  const auto slip = recordFromJsonIfKnown(R"({"type":"levle","id":"q"})", &slips);
  ASSERT_FALSE(slip);
  EXPECT_EQ(slip.error().text(),
            "type: expected one of header, level, query, progress, trajectory, result, recording, "
            "params, metrics, end, found \"levle\" (did you mean \"level\"?)");
  unknown = recordFromJsonIfKnown(R"({"type":"levle","id":"q"})");
  ASSERT_TRUE(unknown) << "a later version of the schema may have it";
  EXPECT_FALSE(unknown->has_value());
}

TEST(JsonWriting, RefusesRecordsThatNoReaderAccepts) {
  RecordBuilder nan, range, text;
  nan.root().initQuery().setTimeLimit(__builtin_nanf(""));
  range.root().initLevel().initPhysics().setGravity(3000);
  const char bad[] = "a\xff";
  text.root().initLevel().initParts(2)[1].initTags(1).set(0, capnp::Text::Reader(bad, 2));
  EXPECT_EQ(recordToJson(nan.reader()).error().text(),
            "timeLimit: expected a finite number, found nan");
  EXPECT_EQ(recordToJson(range.reader()).error().text(),
            "physics.gravity: expected a number from 0 to 2000, found 3000");
  EXPECT_EQ(recordToJson(text.reader()).error().text(), "parts[1].tags[0]: expected UTF-8 text");
}

// The nearest float to 0.2 is slightly greater than 0.2.
TEST(JsonWriting, AcceptsABoundDespiteFloatRounding) {
  RecordBuilder max;
  max.root().initLevel().initPhysics().setContactSkin(0.2f);
  EXPECT_TRUE(recordToJson(max.reader()));
}

}  // namespace
}  // namespace obby::io
