// Class defaults, inheritance and the spelling of property names.
#include "engine/classes/class_defaults.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/classes/class_table.h"
#include "engine/classes/default_rows.h"
#include "engine/values/brick_colors.h"
#include "import/format/property_names.h"

namespace obby::test {
namespace {

using namespace importer;

TEST(ClassDefaults, AreInheritedAndOverridden) {
  Instance seat, truss, unknown;
  seat.className = "Seat";
  truss.className = "TrussPart";
  unknown.className = "NeverHeardOf";
  EXPECT_EQ(get<Vec3>(seat, "Size"), (Vec3{4, 1.2f, 2}));
  EXPECT_EQ(get<Vec3>(truss, "Size"), (Vec3{2, 2, 2}));
  EXPECT_TRUE(get<bool>(seat, "CanCollide"));
  EXPECT_FALSE(get<bool>(unknown, "CanCollide"));
  EXPECT_TRUE(get<bool>(unknown, "Archivable"));
  EXPECT_EQ(get<EnumItem>(seat, "Shape").value, 1u);
  EXPECT_EQ(defaultOf("TrussPart", "Shape"), nullptr);
  seat.properties["Size"] = Vec3{1, 1, 1};
  EXPECT_EQ(get<Vec3>(seat, "Size"), (Vec3{1, 1, 1}));
}

TEST(ClassDefaults, IsAFollowsTheAncestors) {
  EXPECT_TRUE(isA("SpawnLocation", "BasePart"));
  EXPECT_TRUE(isA("SpawnLocation", "SpawnLocation"));
  EXPECT_TRUE(isA("UnionOperation", "PVInstance"));
  EXPECT_TRUE(isA("NeverHeardOf", "Instance"));
  EXPECT_FALSE(isA("NeverHeardOf", "BasePart"));
  EXPECT_FALSE(isA("BasePart", "SpawnLocation"));
  EXPECT_FALSE(isA("Part", "NeverHeardOf"));
  EXPECT_TRUE(isA("NeverHeardOf", "NeverHeardOf"));
}

TEST(ClassDefaults, EveryDefaultNamesAClassAndAPropertyOnce) {
  std::set<std::pair<std::string_view, std::string_view>> rows;
  for (const DefaultRow& row : defaultRows()) {
    EXPECT_NE(engine::ClassTable::get().baseOf(row.className), nullptr) << row.className;
    EXPECT_TRUE(rows.insert({row.className, row.property}).second) << row.property;
    // The importer would never find a default under a name that documents do not use.
    EXPECT_EQ(spellingOf(row.className, row.property).name, row.property);
  }
}

TEST(ClassDefaults, NumbersAreCoercedToTheKindOfTheDefault) {
  EXPECT_EQ(std::get<double>(coerceTo(int64_t{3}, 0.0)), 3.0);
  EXPECT_EQ(std::get<int64_t>(coerceTo(3.0, int64_t{0})), 3);
  EXPECT_EQ(std::get<bool>(coerceTo(int64_t{1}, false)), true);
  EXPECT_EQ(std::get<EnumItem>(coerceTo(int64_t{7}, EnumItem{})).value, 7u);
  EXPECT_EQ(std::get<std::string>(coerceTo(std::string("x"), 0.0)), "x");
  EXPECT_TRUE(std::holds_alternative<double>(coerceTo(1e300, int64_t{0})));
}

TEST(PropertyNames, OldAndFileSpellingsBecomeTheEnginesOwn) {
  const auto name = [](const char* className, const char* property) {
    return spellingOf(className, property).name;
  };
  EXPECT_EQ(name("Part", "size"), "Size");
  EXPECT_EQ(name("Part", "Size"), "Size");
  EXPECT_EQ(name("Part", "shape"), "Shape");
  EXPECT_EQ(name("Part", "Color3uint8"), "Color");
  EXPECT_EQ(name("Part", "BrickColor"), "Color");
  EXPECT_EQ(name("SomethingElse", "BrickColor"), "BrickColor");
  EXPECT_EQ(name("Humanoid", "Health_XML"), "Health");
  EXPECT_EQ(name("WeldConstraint", "Part0Internal"), "Part0");
  EXPECT_EQ(name("Model", "ScaleFactor"), "Scale");
  EXPECT_EQ(name("Part", "TopSurface"), "");
  EXPECT_TRUE(spellingOf("Part", "brickColor").legacy);
  EXPECT_FALSE(spellingOf("Part", "Color").legacy);
}

TEST(BrickColors, KnownNumbersAndTheFallback) {
  const auto rgb = [](int64_t number) {
    const ColorRgb c = brickColor(number);
    return c.r << 16 | c.g << 8 | c.b;
  };
  EXPECT_EQ(rgb(1), 0xf2f3f3);
  EXPECT_EQ(rgb(21), 0xc4281c);
  EXPECT_EQ(rgb(194), 0xa3a2a5);
  EXPECT_EQ(rgb(1032), 0xff00bf);
  EXPECT_EQ(rgb(-1), 0xa3a2a5);
  EXPECT_EQ(rgb(4), 0xa3a2a5);
  EXPECT_EQ(brickColorNumber(brickColor(1004)).value_or(0), 1004);
  EXPECT_EQ(brickColorNumber(brickColor(4)).value_or(0), 194);
  EXPECT_FALSE(brickColorNumber(ColorRgb{1, 2, 3}).has_value());
}

}  // namespace
}  // namespace obby::test
