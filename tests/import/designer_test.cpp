// Data that the Studio plugin keeps in a place: queries, calibrated physics, recorded motion.
#include "import/records/designer_queries.h"

#include <map>

#include "import/importer.h"
#include "import/scene.h"
#include "level/level.h"
#include "level/resolve_places.h"

namespace obby::test {
namespace {

struct Place : Scene {
  Place() {
    part("Spawn", {}, workspace, "SpawnLocation");
    tag(part("Gate", {60, 0, 0}), "Goal");
    folder = add("Folder", "ObbyQueries", add("ServerStorage", "ServerStorage", kNoInstance));
  }
  InstanceId query(const std::string& id) { return add("Configuration", id, folder); }
  InstanceId region(InstanceId query, const std::string& name, const std::string& kind) {
    const InstanceId id = add("Configuration", name, query);
    attribute(id, "kind", kind);
    attribute(id, "cframe", CFrame{{10, 5, 0}, {}});
    attribute(id, "size", Vec3{4, 6, 4});
    return id;
  }
  importer::Import imported() const { return importer::importDocument(document, {}); }

  InstanceId folder;
};

TEST(DesignerQueries, AreReadWithTheirRegionsAndLimits) {
  Place place;
  const InstanceId query = place.query("two jumps");
  place.attribute(query, "maxJumps", 2.0);
  place.attribute(query, "timeLimit", 8.5);
  place.region(query, "from", "start");
  const InstanceId later = place.region(query, "second", "waypoint");
  place.attribute(later, "order", 2.0);
  place.attribute(later, "segmentJumps", 1.0);
  place.attribute(place.region(query, "first", "waypoint"), "order", 1.0);
  const InstanceId goal = place.add("Configuration", "the gate", query);
  place.attribute(goal, "kind", std::string("goal"));
  place.attribute(goal, "part", std::string("Gate"));
  place.attribute(goal, "touch", true);
  place.region(query, "not here", "avoid");
  const importer::Import import = place.imported();
  EXPECT_TRUE(import.warnings.empty()) << import.warnings.front();
  ASSERT_EQ(import.queries.size(), 2u) << "the designer's, and the stage's";
  const auto q = import.queries[0].reader().getQuery();
  EXPECT_EQ(q.getId(), "two jumps");
  EXPECT_EQ(q.getMaxJumps(), 2);
  EXPECT_FLOAT_EQ(q.getTimeLimit(), 8.5f);
  EXPECT_EQ(q.getStart().getRegion().getName(), "from");
  ASSERT_EQ(q.getWaypoints().size(), 2u);
  EXPECT_EQ(q.getWaypoints()[0].getRegion().getName(), "first");
  EXPECT_EQ(q.getWaypoints()[1].getSegmentJumps(), 1);
  EXPECT_EQ(q.getGoal().getPart(), "Gate");
  EXPECT_TRUE(q.getGoal().getTouch());
  EXPECT_EQ(q.getAvoid()[0].getSize().getY(), 6);
  // The level accepts the resulting query.
  const auto level = level::Level::compile(import.level.reader().getLevel());
  ASSERT_TRUE(level);
  io::RecordBuilder copy(import.queries[0].reader());
  ASSERT_TRUE(level::resolvePlaces(import.level.reader().getLevel(), copy.root().getQuery()));
  const auto compiled = level::Query::compile(copy.reader().getQuery(), *level);
  EXPECT_TRUE(compiled) << compiled.error().text();
}

TEST(DesignerQueries, AreReadFromTheFolderDespiteNamesakes) {
  Place place;
  const InstanceId storage = place.document.instances[place.folder].parent;
  place.add("Configuration", "ObbyQueries", storage);
  std::swap(place.document.instances[storage].children.front(),
            place.document.instances[storage].children.back());
  place.region(place.query("mine"), "to", "goal");
  const importer::Import import = place.imported();
  ASSERT_EQ(import.queries.size(), 2u) << "the designer's, and the stage's";
  EXPECT_EQ(import.queries[0].reader().getQuery().getId(), "mine");
}

TEST(DesignerQueries, ForbidStatesAndDelayStartsWithAnyRegion) {
  Place place;
  for (const char* id : {"at the spawn", "at a region"}) {
    const InstanceId query = place.query(id);
    place.attribute(query, "forbid", std::string("climbing, fallingDown"));
    place.attribute(query, "startTick", 90.0);
    place.region(query, "goal", "goal");
  }
  place.region(place.document.instances[place.folder].children[1], "from", "start");
  const importer::Import import = place.imported();
  EXPECT_TRUE(import.warnings.empty()) << import.warnings.front();
  const auto level = level::Level::compile(import.level.reader().getLevel());
  ASSERT_TRUE(level);
  for (size_t i = 0; i < 2; ++i) {
    const auto q = import.queries[i].reader().getQuery();
    ASSERT_EQ(q.getForbid().size(), 2u);
    EXPECT_EQ(q.getForbid()[0], schema::PlayerState::CLIMBING);
    EXPECT_EQ(q.getForbid()[1], schema::PlayerState::FALLING_DOWN);
    EXPECT_EQ(q.getStart().getTick(), 90u);
    EXPECT_EQ(q.getStart().hasRegion(), i == 1);
    const auto compiled = level::Query::compile(q, *level);
    ASSERT_TRUE(compiled) << compiled.error().text();
    EXPECT_EQ(compiled->view().startTick, 90u);
  }
}

TEST(DesignerQueries, StartAfterTheSameSecondsAtAnyTickRate) {
  Place place;
  place.attribute(place.folder, "physics", std::string(R"({"type":"params","controlRate":240})"));
  const InstanceId query = place.query("later");
  place.attribute(query, "startTick", 90.0);
  place.region(query, "goal", "goal");
  const importer::Import import = place.imported();
  EXPECT_TRUE(import.warnings.empty()) << import.warnings.front();
  EXPECT_EQ(import.level.reader().getLevel().getPhysics().getControlRate(), 240);
  EXPECT_EQ(import.queries[0].reader().getQuery().getStart().getTick(), 360u) << "1.5 s";
}

TEST(DesignerQueries, InvalidStatesAndTicksAreReported) {
  Place place;
  const InstanceId query = place.query("odd");
  place.attribute(query, "forbid", std::string("climbing,flying"));
  place.attribute(query, "startTick", -3.0);
  place.region(query, "goal", "goal");
  place.attribute(place.query("worse"), "forbid", 3.0);
  const importer::Import import = place.imported();
  std::string all;
  for (const std::string& warning : import.warnings) all += warning + "\n";
  for (const char* word : {"flying", "startTick", "'forbid' that is not a string"})
    EXPECT_NE(all.find(word), std::string::npos) << word << " in\n" << all;
  const auto q = import.queries[0].reader().getQuery();
  EXPECT_EQ(q.getForbid().size(), 1u);
  EXPECT_FALSE(q.hasStart());
}

TEST(DesignerQueries, UnusableSettingsAreReported) {
  Place place;
  place.query("no goal");
  const InstanceId query = place.query("odd");
  place.attribute(query, "maxJumps", 2.5);
  place.attribute(query, "colour", std::string("red"));
  place.region(query, "goal", "goal");
  place.attribute(place.region(query, "flat", "avoid"), "size", Vec3{4, 0, 4});
  const importer::Import import = place.imported();
  ASSERT_EQ(import.warnings.size(), 4u);
  std::string all;
  for (const std::string& warning : import.warnings) all += warning + "\n";
  for (const char* word : {"no goal", "maxJumps", "colour", "flat"})
    EXPECT_NE(all.find(word), std::string::npos) << word << " in\n" << all;
  EXPECT_EQ(import.queries[0].reader().getQuery().getId(), "odd");
  EXPECT_EQ(import.queries[0].reader().getQuery().getMaxJumps(), -1);
}

TEST(DesignerQueries, RegionsWithoutAKindAndSecondStartsAreReported) {
  Place place;
  const InstanceId query = place.query("odd");
  place.region(query, "goal", "goal");
  place.region(query, "here", "start");
  place.region(query, "there", "start");
  place.region(query, "lava", "Avoid");
  const importer::Import import = place.imported();
  ASSERT_EQ(import.warnings.size(), 2u);
  EXPECT_EQ(import.warnings[0],
            "test.rbxl: ServerStorage/ObbyQueries/odd/lava has the unknown kind 'Avoid' and is "
            "left out; expected one of goal, start, avoid, visit, waypoint");
  EXPECT_EQ(import.warnings[1],
            "test.rbxl: ServerStorage/ObbyQueries/odd/there is an extra start and is left out; a "
            "query can have only one");
  EXPECT_EQ(import.queries[0].reader().getQuery().getStart().getRegion().getName(), "here");
}

TEST(DesignerQueries, TakeTheirIdsFromTheStages) {
  Place place;
  place.region(place.query("stage1"), "goal", "goal");
  const importer::Import import = place.imported();
  ASSERT_EQ(import.queries.size(), 1u);
  EXPECT_EQ(import.queries[0].reader().getQuery().getGoal().getName(), "goal");
}

TEST(DesignerPhysics, HoldForTheLevel) {
  Place place;
  place.attribute(place.folder, "physics", std::string(R"({"type":"params","gravity":190})"));
  EXPECT_EQ(place.imported().level.reader().getLevel().getPhysics().getGravity(), 190);
  place.attribute(place.folder, "physics", std::string(R"({"gravity":190)"));
  const importer::Import broken = place.imported();
  EXPECT_EQ(broken.level.reader().getLevel().getPhysics().getGravity(), 196.2f);
  ASSERT_EQ(broken.warnings.size(), 1u);
  EXPECT_NE(broken.warnings[0].find("physics"), std::string::npos);
}

TEST(RecordedMotion, BecomesThePartsTrack) {
  Place place;
  const InstanceId id = place.part("Ferry", {0, 4, 0});
  place.attribute(id, "ObbyMotion",
                  std::string(R"({"keys":[{"position":[0,4,0]},{"time":2,"position":[9,4,0]}],)"
                              R"("repeat":"pingPong","carries":true})"));
  const LevelDraft& level = place.level();
  ASSERT_TRUE(place[id].motion);
  EXPECT_EQ(place[id].motion->keys.size(), 2u);
  EXPECT_EQ(place[id].motion->keys[1].pose.position.x, 9);
  EXPECT_EQ(place[id].motion->repeat, importer::Repeat::pingPong);
  EXPECT_TRUE(place[id].motion->carries);
  EXPECT_NE(place.evidence(id, "motion").find("recorded"), std::string::npos);
  EXPECT_EQ(level.unmodelled.count("recorded motion"), 0u);
}

TEST(RecordedMotion, InvalidMotionIsReported) {
  Place place;
  const InstanceId id = place.part("Ferry");
  place.attribute(id, "ObbyMotion", std::string("{\"keys\":[{\"time\":\"soon\"}]}"));
  place.level();
  EXPECT_FALSE(place[id].motion);
  EXPECT_EQ(place.unmodelled("recorded motion"), 1u);
}

TEST(RecordedMotion, MotionThatTheSimulatorRefusesIsOmitted) {
  for (const char* motion : {R"({"spin":{"axis":[0,0,0],"speed":1}})", R"({"spin":{}})",
                             R"({"spin":{"speed":1,"pivot":[10000000,0,0]}})",
                             R"({"keys":[{"time":2},{"time":1,"position":[0,4,0]}]})"}) {
    Place place;
    const InstanceId id = place.part("Ferry");
    place.attribute(id, "ObbyMotion", std::string(motion));
    const importer::Import import = place.imported();
    const auto level = level::Level::compile(import.level.reader().getLevel());
    EXPECT_TRUE(level) << motion << ": " << level.error().text();
    place.level();
    EXPECT_FALSE(place[id].motion);
    EXPECT_EQ(place.unmodelled("motion out of range"), 1u);
  }
}

TEST(RecordedMotion, HasASpinWithAndWithoutKeys) {
  Place place;
  const InstanceId log = place.part("Log", {60, 0, 0}), drum = place.part("Drum", {90, 0, 0});
  place.attribute(log, "ObbyMotion",
                  std::string(R"({"spin":{"axis":[0,0,1],"speed":1.5,"pivot":[0,2,0]}})"));
  place.attribute(drum, "ObbyMotion",
                  std::string(R"({"keys":[{"position":[90,0,0]},{"time":2,"position":[90,4,0]}],)"
                              R"("spin":{"speed":2},"offset":0.25})"));
  const importer::Import import = place.imported();
  std::map<std::string, schema::Motion::Reader> motions;
  for (const auto part : import.level.reader().getLevel().getParts())
    if (part.hasMotion()) motions[part.getName()] = part.getMotion();
  ASSERT_EQ(motions.size(), 2u);
  EXPECT_EQ(motions["Log"].getKeys().size(), 0u);
  EXPECT_EQ(motions["Log"].getSpin().getAxis().getZ(), 1);
  EXPECT_EQ(motions["Log"].getSpin().getSpeed(), 1.5f);
  EXPECT_EQ(motions["Log"].getSpin().getPivot().getY(), 2);
  EXPECT_EQ(motions["Drum"].getKeys().size(), 2u);
  EXPECT_EQ(motions["Drum"].getSpin().getSpeed(), 2);
  EXPECT_EQ(motions["Drum"].getOffset(), 0.25f);
  const auto level = level::Level::compile(import.level.reader().getLevel());
  EXPECT_TRUE(level) << level.error().text();
}

}  // namespace
}  // namespace obby::test
