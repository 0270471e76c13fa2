// Parts whose scripts compare the player's position: only the root touches them.
#include "import/scene.h"

namespace obby::test {
namespace {

// Returns a script that evaluates `test` with the box and the body's parts in each frame. It kills
// if the result is true.
std::string pollOf(const std::string& test) {
  return R"(local box = workspace.Box
local function inside(point)
  local p, h = box.CFrame:PointToObjectSpace(point), box.Size / 2
  return math.abs(p.X) <= h.X and math.abs(p.Y) <= h.Y and math.abs(p.Z) <= h.Z
end
game:GetService("RunService").Heartbeat:Connect(function()
  for _, player in game.Players:GetPlayers() do
    local body = player.Character
    local root = body and body:FindFirstChild("HumanoidRootPart")
    if root and ()" +
         test + R"() then body.Humanoid.Health = 0 end
  end
end))";
}

struct BoxScene {
  Scene scene;
  InstanceId box = scene.part("Box", {0, 30, -60});

  explicit BoxScene(const std::string& script, bool solid = false) {
    scene.part("SpawnLocation", {}, scene.workspace, "SpawnLocation");
    scene.set(box, "Size", Vec3{8, 6, 4});
    scene.set(box, "CanCollide", solid);
    scene.script(script, scene.scripts);
    scene.level();
  }
  const PartDraft& part() const { return scene[box]; }
};

TEST(ByRoot, PositionsInABoxCountForTheRootOnly) {
  const BoxScene place(pollOf("inside(root.Position)"));
  ASSERT_TRUE(place.part().kill);
  EXPECT_TRUE(place.part().byRoot);
  EXPECT_NE(place.scene.evidence(place.box, "byRoot"), "");
}

TEST(ByRoot, ARotatedBoxCountsForTheRootOnly) {
  BoxScene place("");
  place.scene.set(place.box, "CFrame",
                  CFrame{{0, 30, -60}, {{0.6f, 0, 0.8f}, {0, 1, 0}, {-0.8f, 0, 0.6f}}});
  place.scene.script(pollOf("inside(root.Position)"), place.scene.scripts);
  place.scene.level();
  ASSERT_TRUE(place.part().kill);
  EXPECT_TRUE(place.part().byRoot);
}

TEST(ByRoot, LimbsCountIfTheScriptChecksThem) {
  const BoxScene overlap(pollOf("#workspace:GetPartsInPart(box) > 0"));
  ASSERT_TRUE(overlap.part().kill);
  EXPECT_FALSE(overlap.part().byRoot);
  const BoxScene leg(pollOf("inside(body['Left Leg'].Position) or inside(root.Position)"));
  ASSERT_TRUE(leg.part().kill);
  EXPECT_FALSE(leg.part().byRoot);
}

TEST(ByRoot, AnUnboundedPositionCheckCountsForAllLimbs) {
  const BoxScene place(pollOf("math.abs(root.Position.Z - box.Position.Z) < 2.5"));
  ASSERT_TRUE(place.part().kill);
  EXPECT_FALSE(place.part().byRoot);
}

TEST(ByRoot, ATouchCountsForLimbs) {
  const BoxScene place(R"(workspace.Box.Touched:Connect(function(hit)
  local human = hit.Parent:FindFirstChild("Humanoid")
  if human then human.Health = 0 end
end))");
  ASSERT_TRUE(place.part().kill);
  EXPECT_FALSE(place.part().byRoot);
}

}  // namespace
}  // namespace obby::test
