// Levels reduced to their moving parts.
#include "bridge/moving.h"

#include <gtest/gtest.h>

namespace obby::bridge {
namespace {

TEST(Moving, static_parts_become_empty_and_indices_stay) {
  const auto some = movingParts(
      R"({"type":"level","name":"a","physics":{"gravity":60.5},"parts":[)"
      R"({"name":"Floor","position":[0,-0.5,1e3]},{"name":"Lift","motion":{"keys":[]}},)"
      R"({"name":"Gone","vanish":{"trigger":"timer"}},{"name":"Crate","anchored":false},)"
      R"({"name":"Still","anchored":true,"motion":null},[]]})"
      "\n{\"type\":\"level\",\"name\":\"\\u00e9\\\"\",\"parts\":[]}\n");
  ASSERT_TRUE(some);
  EXPECT_EQ(*some,
            R"({"type":"level","name":"a","physics":{"gravity":60.5},"parts":[)"
            R"({},{"name":"Lift","motion":{"keys":[]}},)"
            R"({"name":"Gone","vanish":{"trigger":"timer"}},{"name":"Crate","anchored":false},)"
            R"({},{}]})"
            "\n{\"type\":\"level\",\"name\":\"\u00e9\\\"\",\"parts\":[]}\n");
}

TEST(Moving, records_without_parts_stay_and_invalid_json_is_an_error) {
  const auto bare = movingParts("{\"type\":\"level\"}");
  ASSERT_TRUE(bare);
  EXPECT_EQ(*bare, "{\"type\":\"level\"}\n");
  const auto none = movingParts("");
  ASSERT_TRUE(none);
  EXPECT_EQ(*none, "");
  EXPECT_FALSE(movingParts("{\"type\":\n"));
}

}  // namespace
}  // namespace obby::bridge
