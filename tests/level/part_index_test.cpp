// The index finds the same parts as a scan of all parts, even after it has sorted them.
#include "level/part_index.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "io/record.h"
#include "level/resolve_places.h"

namespace obby::level {
namespace {

constexpr const char* kTexts[] = {"Lava",
                                  "S1/Lava",
                                  "Workspace/S1/Lava",
                                  "Workspace/S2/Lava",
                                  "OldS1/Lava",
                                  "/Lava",
                                  "va",
                                  "Lava/",
                                  "Lava/Lava",
                                  "lava",
                                  "L",
                                  "Workspace/S2/L",
                                  "W\xc3\xbc/L",
                                  "Workspace",
                                  "//",
                                  ""};

class PartIndexTest : public testing::Test {
 protected:
  PartIndexTest() {
    constexpr uint32_t kCount = uint32_t(std::size(kTexts));
    auto parts = record.root().initLevel().initParts(3 * kCount);
    for (uint32_t i = 0; i < parts.size(); ++i) {
      parts[i].setName(kTexts[(i * 7 + i / kCount) % kCount]);
      if (i % 3 != 0) parts[i].initSource().setPath(kTexts[(i * 5) % kCount]);
      if (i % 4 == 0) parts[i].getSource().setGuid(kTexts[(i * 3) % kCount]);
      auto tags = parts[i].initTags(i % 3);
      for (uint32_t t = 0; t < tags.size(); ++t)
        tags.set(t, kTexts[(i / 2 * 2 + t * (i & 1)) % kCount]);
    }
  }

  schema::Level::Reader level() { return record.reader().getLevel(); }

  std::vector<uint32_t> partsWhere(const std::function<bool(schema::Part::Reader)>& fits) {
    std::vector<uint32_t> found;
    for (uint32_t i = 0; i < level().getParts().size(); ++i) {
      if (fits(level().getParts()[i])) found.push_back(i);
    }
    return found;
  }

  io::RecordBuilder record;
};

TEST_F(PartIndexTest, FindsTheSameByScanAndWhenSorted) {
  PartIndex index(level());
  size_t found = 0;
  for (int round = 0; round < 4; ++round) {
    for (const char* const name : kTexts) {
      const std::string text = name;
      const auto has = [&](capnp::Text::Reader other) { return other == text.c_str(); };
      const std::string end = "/" + text;
      EXPECT_EQ(index.withGuid(text),
                partsWhere([&](auto p) { return has(p.getSource().getGuid()); }));
      EXPECT_EQ(index.withPath(text), partsWhere([&](auto p) { return pathOf(p) == text; }));
      EXPECT_EQ(index.withName(text), partsWhere([&](auto p) { return has(p.getName()); }));
      EXPECT_EQ(index.withPathEnd(text),
                partsWhere([&](auto p) { return pathOf(p).ends_with(end); }));
      const auto tagged = partsWhere([&](auto p) {
        for (const auto tag : p.getTags()) {
          if (has(tag)) return true;
        }
        return false;
      });
      EXPECT_EQ(index.withTag(text), tagged);
      found += tagged.size() + index.withPathEnd(text).size();
    }
  }
  EXPECT_GT(found, 100u);
}

TEST(PartIndex, FindsNothingInALevelWithoutParts) {
  io::RecordBuilder record;
  record.root().initLevel();
  PartIndex index(record.reader().getLevel());
  for (int i = 0; i < 40; ++i) {
    EXPECT_TRUE(index.withName("Lava").empty());
    EXPECT_TRUE(index.withPathEnd("Lava").empty());
    EXPECT_TRUE(index.withTag("Lava").empty());
  }
}

// A separate scan for each name would take minutes.
TEST(PartIndex, FindsAsManyNamesAsALargeLevelHasParts) {
  io::RecordBuilder level, query;
  constexpr uint32_t kCount = uint32_t(kMaxPlaces);
  auto parts = level.root().initLevel().initParts(kCount);
  auto avoid = query.root().initQuery().initAvoid(kCount);
  for (uint32_t i = 0; i < kCount; ++i) {
    parts[i].setName("Lava");
    parts[i].initSource().setPath(fmt::format("Workspace/Stage{}/Lava", i));
    avoid[i].setPart(fmt::format("Stage{}/Lava", kCount - 1 - i));
  }
  const Status status = resolvePlaces(level.reader().getLevel(), query.root().getQuery());
  ASSERT_TRUE(status) << status.error().text();
  const auto list = query.reader().getQuery().getAvoid();
  ASSERT_EQ(list.size(), kCount);
  for (uint32_t i = 0; i < kCount; ++i) {
    ASSERT_EQ(list[i].getPartIndex(), int32_t(kCount - 1 - i));
  }
}

}  // namespace
}  // namespace obby::level
