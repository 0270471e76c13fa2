// Texts that select parts and boxes of a level.
#include "level/select_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/tower.h"

namespace obby::level {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class SelectTest : public testing::Test {
 protected:
  schema::Level::Reader level() { return record.reader().getLevel(); }
  std::vector<uint32_t> parts(const std::string& selector) {
    auto found = matchParts(level(), selector);
    EXPECT_TRUE(found) << found.error().text();
    return found ? *found : std::vector<uint32_t>();
  }
  std::string error(const std::string& selector) {
    const auto found = matchPart(level(), selector);
    EXPECT_FALSE(found);
    return found ? "" : found.error().text();
  }
  io::RecordBuilder record = support::tower();
};

TEST_F(SelectTest, SelectsByNamePathSuffixTagGuidAndIndex) {
  EXPECT_THAT(parts("Base"), ElementsAre(0));
  EXPECT_THAT(parts("Workspace/S2/Lava"), ElementsAre(2));
  EXPECT_THAT(parts("S1/Lava"), ElementsAre(1));
  EXPECT_THAT(parts("Lava"), ElementsAre(1, 2));
  EXPECT_THAT(parts("#Kill"), ElementsAre(1, 2));
  EXPECT_THAT(parts("#Hot"), ElementsAre(2));
  EXPECT_THAT(parts("AB12"), ElementsAre(3));
  EXPECT_THAT(parts("part:3"), ElementsAre(3));
}

TEST_F(SelectTest, SeveralMatchesAreListed) {
  EXPECT_EQ(error("Lava"),
            "expected the name of one part, but 'Lava' names 2 parts of level 'tower' (give one of "
            "'S1/Lava', 'S2/Lava')");
}

TEST_F(SelectTest, ListedNamesAreValidSelectors) {
  PartIndex index(level());
  EXPECT_EQ(selectorOf(index, 0), "Base");
  EXPECT_EQ(selectorOf(index, 1), "S1/Lava");
  EXPECT_EQ(selectorOf(index, 2), "S2/Lava");
  for (uint32_t i = 0; i < level().getParts().size(); ++i) {
    EXPECT_THAT(parts(selectorOf(index, i)), ElementsAre(i));
  }
}

TEST_F(SelectTest, PartsWithoutAUniqueNameAreListedByIndex) {
  record = *io::recordFromJson(
      R"({"type":"level","name":"odd","parts":[{"name":"A"},{"name":"A"},{"name":"#B"},)"
      R"({"name":"1,2,3,4,5,6"},{"name":"touch:C"},{},{"name":"D","source":{"path":"/D"}},)"
      R"({"name":"D","source":{"path":"x//D"}}]})");
  PartIndex index(level());
  const char* const expected[] = {"part:0", "part:1", "part:2", "part:3", "part:4", "part:5", "/D"};
  for (uint32_t i = 0; i < 7; ++i) EXPECT_EQ(selectorOf(index, i), expected[i]);
  EXPECT_EQ(selectorOf(index, 7), "x//D");
  EXPECT_EQ(error("A"),
            "expected the name of one part, but 'A' names 2 parts of level 'odd' (give one of "
            "'part:0', 'part:1')");
}

TEST_F(SelectTest, NoMatchSuggestsSimilarNames) {
  EXPECT_THAT(error("lav"), HasSubstr("similar: 'S1/Lava', 'S2/Lava'"));
  EXPECT_THAT(error("nothing"), HasSubstr("part:INDEX"));
  EXPECT_THAT(error("Basse"), HasSubstr("similar: 'Base'")) << "a slip of the fingers";
  EXPECT_THAT(error("Lavva"), HasSubstr("similar: 'S1/Lava', 'S2/Lava'"));
  EXPECT_THAT(error("part:9"), HasSubstr("parts 0 to 3"));
}

TEST_F(SelectTest, NoMatchOfATagSuggestsSimilarTags) {
  EXPECT_THAT(error("#kill"), HasSubstr("(similar: #Kill)"));
  EXPECT_THAT(error("#O"), HasSubstr("(similar: #Hot)"));
  EXPECT_THAT(error("#Kil1"), HasSubstr("(similar: #Kill)"));
  EXPECT_THAT(error("#"), HasSubstr("part:INDEX"));
}

TEST_F(SelectTest, TheErrorMentionsALevelWithoutParts) {
  record = *io::recordFromJson(R"({"type":"level","name":"void"})");
  EXPECT_THAT(error("part:0"), HasSubstr("level 'void' has no parts"));
}

TEST(BoxFromText, ReadsSixNumbersAndNothingElse) {
  const auto box = boxFromText("1,-2.5,3e1,4,5,6");
  ASSERT_TRUE(box && *box);
  EXPECT_TRUE((*box)->position == (Vec3{1, -2.5f, 30}));
  EXPECT_TRUE((*box)->size == (Vec3{4, 5, 6}));
  for (const char* text : {"", "1,2,3", "1,2,3,4,5,6,7", "1,2,3,4,5,x", "Part,1", "1;2;3;4;5;6"}) {
    const auto other = boxFromText(text);
    ASSERT_TRUE(other) << text;
    EXPECT_FALSE(other->has_value()) << text;
  }
  EXPECT_FALSE(boxFromText("1,2,3,4,0,6"));
  EXPECT_FALSE(boxFromText("1,2,3,4,nan,6"));
  EXPECT_FALSE(boxFromText("inf,2,3,4,5,6"));
  EXPECT_FALSE(boxFromText("1e39,2,3,4,5,6")) << "no float, and no part's name";
  EXPECT_FALSE(boxFromText("1,2,3,4,5,1e-60"));
}

TEST_F(SelectTest, RegionsGrowUpwardAlsoForPartsThatLieOnTheirSide) {
  const PlainRegion base = regionAround(level().getParts()[0]);
  EXPECT_TRUE(base.size == (Vec3{10, 1.5f, 10}));
  EXPECT_FLOAT_EQ(base.position.y, 0.25f);
  const PlainRegion top = regionAround(level().getParts()[3]);  // local X points up
  EXPECT_TRUE(top.size == (Vec3{4.5f, 3, 4}));
  EXPECT_NEAR(top.position.y, 9.25f, 1e-5);
  const PlainRegion standing = regionOnTop(level().getParts()[3]);
  EXPECT_NEAR(standing.position.y - standing.size.y / 2, 11, 1e-5);
}

}  // namespace
}  // namespace obby::level
