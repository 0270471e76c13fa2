// All that scripts do is kept up to a bound; those that do more are named.
#include <cstddef>
#include <string>
#include <vector>

#include "import/luau/changes.h"
#include "import/luau/timeline_room.h"
#include "import/scene.h"
#include "import/unread_code.h"

namespace obby::test {
namespace {

using importer::ScriptReading;
using importer::Timeline;

const std::string kSets = "for i = 1, 5 do workspace.Part.Transparency = i / 10 end ";
const std::string kPart = "workspace.Part";
const std::string kTouched = kPart + ".Touched:Connect(function(hit) ";
const std::string kHurts = "hit.Parent.Humanoid:TakeDamage(10) ";

// The readings of a scene's scripts, of which no more is kept than there is `room` for.
struct Readings {
  Readings(const Scene& scene, size_t room)
      : tree(scene.document), all(importer::readScripts(tree, room)) {}

  size_t events(size_t script) const {
    size_t sum = 0;
    for (const Timeline& timeline : all[script].timelines) sum += timeline.events.size();
    return sum;
  }
  size_t events() const {
    size_t sum = 0;
    for (size_t script = 0; script < all.size(); ++script) sum += events(script);
    return sum;
  }
  // Timelines but for the script's own: those of handlers and threads.
  size_t others(size_t script) const { return all[script].timelines.size() - 1; }
  size_t kept(size_t script) const { return events(script) + others(script); }

  const importer::Tree tree;
  const std::vector<ScriptReading> all;
};

TEST(ScriptRoom, TheFirstEventsOfAPlaceAreKept) {
  Scene scene;
  scene.part("Part");
  for (int i = 0; i < 3; ++i) scene.script(kSets, scene.scripts);
  for (const size_t most : {15u, 14u, 10u, 7u, 0u}) {
    const Readings readings(scene, most);
    ASSERT_EQ(readings.all.size(), 3u);
    EXPECT_EQ(readings.events(), most);
    for (size_t script = 0; script < 3; ++script)
      EXPECT_EQ(readings.all[script].exhausted, 5 * (script + 1) > most) << most;
  }
}

// Whatever they do that makes events, and however it is read on behind it.
TEST(ScriptRoom, AllWaysToDoSomethingFindItFull) {
  const std::string tween =
      "local t = game:GetService('TweenService'):Create(p, TweenInfo.new(1), "
      "{Position = Vector3.new(0, 9, 0), Transparency = 1}) t:Play() ";
  const std::string texts[] = {
      "p.Position = Vector3.new(0, 5, 0) p.CFrame *= CFrame.new(0, 1, 0)",
      "p.Orientation = Vector3.new(0, 90, 0)",
      "workspace.Model:PivotTo(CFrame.new(0, 5, 0)) workspace.Model:PivotTo(unknown)",
      tween + "t:Pause() t:Play() t:Cancel() t.Completed:Wait() p.CanCollide = false",
      tween + "t.Completed:Connect(function() t:Play() end)",
      "while true do " + tween + "wait(1) p.CanCollide = not p.CanCollide end",
      "while true do p.CFrame *= CFrame.Angles(0, 0.1, 0) wait() end",
      "game.RunService.Heartbeat:Connect(function() p.Position += Vector3.new(0, 1, 0) end)",
      "p.Parent = nil p.Parent = workspace p:Destroy() workspace.Model:ClearAllChildren()",
      "game:GetService('Debris'):AddItem(p, 3) game:GetService('Debris'):AddItem(p, unknown)",
      "p.CanCollide = false local function f() p.Transparency = 1 wait(1) f() end f()",
      kTouched + kHurts + "hit.Parent.HumanoidRootPart.Velocity = Vector3.new(0, 90, 0) end)",
      kTouched + "hit.Parent:PivotTo(CFrame.new(0, 5, 0)) p.Anchored = false end)",
      kTouched + "hit.Parent.Humanoid.WalkSpeed = 50 Instance.new('Part').Parent = workspace end)"};
  for (const std::string& text : texts) {
    Scene scene;
    scene.part("Part");
    scene.part("Inner", {}, scene.add("Model", "Model", scene.workspace));
    scene.script("local p = workspace.Part " + text, scene.scripts);
    const Readings whole(scene, importer::kScriptRoom);
    EXPECT_GT(whole.events(), 0u) << text;
    const Readings none(scene, 0), one(scene, 1);
    EXPECT_EQ(none.kept(0), 0u) << text;
    EXPECT_TRUE(none.all[0].exhausted) << text;
    EXPECT_EQ(one.kept(0), 1u) << text;
    EXPECT_EQ(one.all[0].exhausted, whole.kept(0) > 1) << text;
  }
}

// What the second reading of a handler leaves out takes no room from the next one, nor from others.
TEST(ScriptRoom, OfASecondReadingTheHarmAloneTakesRoom) {
  const auto wakes = [](const std::string& flag) {
    return "local " + flag + " = false " + kTouched + "if " + flag + " then " + kHurts + "end " +
           kSets + flag + " = true end) ";
  };
  Scene scene;
  scene.part("Part");
  scene.script(wakes("first") + wakes("second"), scene.scripts);
  scene.script(kSets, scene.scripts);
  // Two handlers of five, a handler of a harm, and one of six for a while, of which one stays.
  const Readings whole(scene, 12 + 2 + 7);
  EXPECT_EQ(whole.events(0), 12u);
  EXPECT_EQ(whole.others(0), 4u);
  EXPECT_EQ(whole.events(1), 5u);
  EXPECT_FALSE(whole.all[0].exhausted || whole.all[0].cutAgain || whole.all[1].exhausted);
  const Readings cut(scene, 20);
  EXPECT_EQ(cut.events(0), 12u);
  EXPECT_EQ(cut.others(0), 4u);
  EXPECT_EQ(cut.events(1), 4u);
  EXPECT_TRUE(cut.all[0].cutAgain && cut.all[1].exhausted);
  EXPECT_FALSE(cut.all[0].exhausted);
}

// What another script has set wakes a trap in a reading of its own, for which there is no room.
TEST(ScriptRoom, ATrapThatFindsNoRoomIsNamed) {
  Scene scene;
  scene.value("BoolValue", "On", false, scene.part("Part"));
  scene.script(kTouched + "if workspace.Part.On.Value then " + kHurts + "end end)", scene.scripts);
  scene.script("workspace.Part.On.Value = true " + kSets, scene.scripts);
  // A handler, six events of the other script, the handler anew, and the harm in a handler.
  const Readings whole(scene, 10);
  EXPECT_EQ(whole.events(0), 1u);
  EXPECT_FALSE(whole.all[0].cutAgain);
  for (const size_t room : {9u, 8u, 7u}) {
    const Readings cut(scene, room);
    EXPECT_EQ(cut.events(0), 0u);
    EXPECT_EQ(cut.others(0), 1u);
    EXPECT_TRUE(cut.all[0].cutAgain);
    EXPECT_FALSE(cut.all[0].exhausted || cut.all[1].exhausted);
  }
}

// What has been left out stays so, whatever is given back behind it.
TEST(ScriptRoom, ItIsFullFromTheFirstThingLeftOut) {
  importer::luau::TimelineRoom room(2);
  std::vector<importer::ScriptEvent> events;
  room.addTo(events).line = 1;
  EXPECT_TRUE(room.take());
  EXPECT_EQ(room.left(), 0u);
  EXPECT_FALSE(room.isFull());
  room.addTo(events).line = 2;
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].line, 1);
  EXPECT_TRUE(room.isFull());
  room.giveBack(1);
  EXPECT_TRUE(room.take());
  EXPECT_FALSE(room.take());
  EXPECT_TRUE(room.isFull());
}

// Handlers and threads take room even where they do nothing.
TEST(ScriptRoom, TheFirstHandlersOfAPlaceAreKept) {
  const std::string handlers[] = {
      kPart + ".Touched:Connect(function() end)", kPart + ".Touched:Connect(unknown)",
      kPart + ".ChildAdded:Connect(function() end)",
      "game.RunService.Heartbeat:Connect(function() end)", "task.spawn(function() end)"};
  for (const std::string& handler : handlers) {
    Scene scene;
    scene.part("Part");
    for (int i = 0; i < 3; ++i) scene.script("for i = 1, 4 do " + handler + " end", scene.scripts);
    for (const size_t room : {12u, 11u, 8u, 6u, 0u}) {
      const Readings readings(scene, room);
      ASSERT_EQ(readings.all.size(), 3u);
      EXPECT_EQ(readings.kept(0) + readings.kept(1) + readings.kept(2), room) << handler;
      EXPECT_EQ(readings.events(), 0u) << handler;
      for (size_t script = 0; script < 3; ++script)
        EXPECT_EQ(readings.all[script].exhausted, 4 * (script + 1) > room) << handler << room;
    }
  }
}

TEST(ScriptRoom, WhatIsLeftOutIsNamed) {
  Scene scene;
  scene.part("Part");
  scene.script(kSets, scene.scripts);
  for (const bool cut : {false, true}) {
    const Readings readings(scene, cut ? 4u : 5u);
    const importer::Assemblies assemblies(readings.tree);
    LevelDraft level;
    importer::RoleContext context(readings.tree, assemblies, readings.all, level);
    importer::noteUnread(context, readings.all[0]);
    EXPECT_EQ(level.unmodelled.count("very long script"), cut ? 1u : 0u);
  }
}

// Such a name would take a kilobyte of each event.
TEST(ScriptRoom, NoPropertyHasALongName) {
  for (const size_t length : {size_t{101}, size_t{102}}) {
    const std::string name(length, 'a');
    Scene scene;
    scene.part("Part");
    scene.script("workspace.Part." + name + " = 1 " + kTouched + "hit." + name + " = 1 end)",
                 scene.scripts);
    const Readings readings(scene, 9);
    EXPECT_EQ(readings.events(), length == importer::luau::kLongestKey ? 2u : 0u);
    EXPECT_FALSE(readings.all[0].exhausted);
  }
}

TEST(ScriptRoom, ALongNameOfASignalIsCut) {
  Scene scene;
  scene.part("Part");
  scene.script("workspace.Part." + std::string(900, 'a') + ":Connect(function() end)",
               scene.scripts);
  const Readings readings(scene, 9);
  ASSERT_EQ(readings.all[0].timelines.size(), 2u);
  EXPECT_EQ(readings.all[0].timelines[1].signal, std::string(150, 'a'));
}

}  // namespace
}  // namespace obby::test
