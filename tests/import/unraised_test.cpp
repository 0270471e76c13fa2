// The importer notes events that are never raised and handlers that fail, because their effects are
// unknown.
#include <gmock/gmock.h>

#include "import/scene.h"

namespace obby::test {
namespace {

using testing::StartsWith;

constexpr const char* kUnraised = "event that is not raised";

TEST(Unraised, AnUnraisedEventPutsItsPartInDoubt) {
  Scene scene;
  const auto box = scene.part("Box");
  const auto code = scene.add("TextBox", "Code", scene.add("SurfaceGui", "Gui", box));
  scene.script("workspace.Box.Gui.Code.FocusLost:Connect(function() workspace.Box:Destroy() end)",
               scene.scripts);
  (void)code;
  scene.level();
  EXPECT_EQ(scene.unmodelled(kUnraised), 1u);
  EXPECT_EQ(scene[box].doubts, std::vector<std::string>{kUnraised});
  EXPECT_THAT(scene.noteOf(kUnraised), StartsWith("TextBox.FocusLost was not raised while "));
}

TEST(Unraised, ASeatThatScriptsLookAtIsInDoubt) {
  Scene scene;
  const auto seat = scene.part("Boat", {}, scene.workspace, "Seat");
  scene.script("script.Parent:GetPropertyChangedSignal('Occupant'):Connect(print)", seat);
  scene.level();
  EXPECT_EQ(scene[seat].doubts, std::vector<std::string>{kUnraised});
  EXPECT_THAT(scene.noteOf(kUnraised), StartsWith("Seat.Occupant did not change while "));
}

TEST(Unraised, AValueThatScriptsReadIsNoEvent) {
  Scene scene;
  const auto seat = scene.part("Boat", {}, scene.workspace, "Seat");
  scene.script("print(script.Parent.Occupant)", seat);
  scene.level();
  EXPECT_THAT(scene.noteOf(kUnraised), StartsWith("Seat.Occupant did not change while "));
}

TEST(Unraised, RaisedOrIneffectiveEventsAreNotReported) {
  Scene scene;
  scene.part("SpawnLocation", {}, scene.workspace, "SpawnLocation");
  const auto pad = scene.part("Pad", {20, 0, 0});
  scene.script("script.Parent.Touched:Connect(print) script.Parent.Changed:Connect(print)", pad);
  scene.script(R"(game.Players.PlayerRemoving:Connect(print)
game:GetService('RunService').Heartbeat:Connect(function() end)
game.Players.PlayerAdded:Connect(function(player)
  player.CharacterAdded:Connect(function(body)
    local human = body:WaitForChild('Humanoid')
    for _, name in { 'Died', 'Running', 'Jumping', 'Climbing', 'Swimming', 'Seated', 'FreeFalling', 'GettingUp' } do
      human[name]:Connect(function() end)
    end
  end)
end))",
               scene.scripts);
  scene.level();
  EXPECT_EQ(scene.unmodelled(kUnraised), 0u);
}

TEST(Unraised, HandlersThatNeedMissingFeaturesAreDoubts) {
  Scene scene;
  const auto pad = scene.part("Pad");
  scene.script(R"(script.Parent.Touched:Connect(function(hit)
  SharedTable.new()
  hit.Parent.Humanoid.Health = 0
end))",
               pad);
  scene.level();
  EXPECT_EQ(scene.unmodelled("touch handler that fails"), 1u);
}

}  // namespace
}  // namespace obby::test
