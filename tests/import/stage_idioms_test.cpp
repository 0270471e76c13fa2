// Stages by observed effects of scripts: the values that they set, their conditions, and where
// players respawn.
#include "import/spawns.h"

namespace obby::test {
namespace {

constexpr const char* kLeaderstats =
    "game.Players.PlayerAdded:Connect(function(player)\n"
    " local stats = Instance.new('Folder') stats.Name = 'leaderstats' stats.Parent = player\n"
    " local stage = Instance.new('IntValue') stage.Name = 'Stage' stage.Parent = stats\nend)\n";

// Adds pads called 1 to `count` in a folder, in the order of the list, which a script stores.
InstanceId pads(Scene& scene, const std::string& folder, const std::vector<int>& numbers) {
  const auto parent = scene.add("Folder", folder, scene.workspace);
  for (const int n : numbers)
    scene.part("Pad" + std::to_string(n), {30.0f * float(n), 0, 0}, parent);
  return parent;
}

std::string eachPad(const std::string& body) {
  return "for _, pad in workspace.Pads:GetChildren() do\n"
         " pad.Touched:Connect(function(hit)\n"
         "  local player = game.Players:GetPlayerFromCharacter(hit.Parent)\n"
         "  if not player then return end\n"
         "  local n = tonumber(string.match(pad.Name, '%d+'))\n  " +
         body + "\n end)\nend\n";
}

TEST(StageIdioms, StagesSetByTouchesOverrideNamesAndValues) {
  Scene scene;
  spawn(scene, "Start", {});
  const auto folder = pads(scene, "Pads", {1, 2, 3});
  for (const auto id : scene.document.instances[folder].children)
    scene.value("IntValue", "Stage", int64_t{7}, id);
  scene.script(kLeaderstats + eachPad("player.leaderstats.Stage.Value = 4 - n"), scene.scripts);
  EXPECT_EQ(checkpoints(scene.level()), (Names{"Pad3", "Pad2", "Pad1"}));
}

TEST(StageIdioms, ACounterOfTouchesGivesNoOrder) {
  Scene scene;
  spawn(scene, "Start", {});
  pads(scene, "Pads", {3, 1, 2});
  scene.script(kLeaderstats + eachPad("player.leaderstats.Stage.Value += 1"), scene.scripts);
  EXPECT_EQ(checkpoints(scene.level()), (Names{"Pad1", "Pad2", "Pad3"}));
}

TEST(StageIdioms, AttributesEqualToThePadsNumberAreStages) {
  Scene scene;
  spawn(scene, "Start", {});
  pads(scene, "Pads", {2, 1});
  const auto coin = scene.part("Coin", {15, 0, 0});
  scene.script(eachPad("player:SetAttribute('At', n)") +
                   "workspace.Coin.Touched:Connect(function(hit)\n"
                   " local player = game.Players:GetPlayerFromCharacter(hit.Parent)\n"
                   " if player then player:SetAttribute('Money', 25) end\nend)",
               scene.scripts);
  EXPECT_EQ(checkpoints(scene.level()), (Names{"Pad1", "Pad2"}));
  EXPECT_FALSE(scene[coin].checkpoint);
}

TEST(StageIdioms, PadsThatRequireAPredecessorFollowIt) {
  Scene scene;
  spawn(scene, "Start", {});
  const auto folder = scene.add("Folder", "Discs", scene.workspace);
  // The order by distance would be C, B, A.
  for (const auto& [name, x] :
       {std::pair{"A", 90.0f}, std::pair{"B", 60.0f}, std::pair{"C", 30.0f}})
    scene.part(name, {x, 0, 0}, folder);
  scene.script(
      "local before = { B = 'A', C = 'B' }\n"
      "for _, pad in workspace.Discs:GetChildren() do\n"
      " pad.Touched:Connect(function(hit)\n"
      "  local player = game.Players:GetPlayerFromCharacter(hit.Parent)\n"
      "  if not player then return end\n"
      "  local last = player:FindFirstChild('Last')\n"
      "  if not last then last = Instance.new('ObjectValue') last.Name = 'Last' last.Parent = "
      "player end\n"
      "  local now = last.Value and last.Value.Name\n"
      "  if before[pad.Name] == now then last.Value = pad end\n"
      " end)\nend",
      scene.scripts);
  EXPECT_EQ(checkpoints(scene.level()), (Names{"A", "B", "C"}));
}

TEST(StageIdioms, PadsWithUntestedConditionsFollowTheirNumbers) {
  Scene scene;
  spawn(scene, "Start", {});
  pads(scene, "Pads", {5, 4, 3, 2, 1});  // the importer's tour touches the last pad first
  scene.script(kLeaderstats + eachPad("local stage = player.leaderstats.Stage\n"
                                      "  if n == stage.Value + 1 then stage.Value = n end"),
               scene.scripts);
  EXPECT_EQ(checkpoints(scene.level()), (Names{"Pad1", "Pad2", "Pad3", "Pad4", "Pad5"}));
}

// A script of the body receives each touch of the Humanoid, and recognises the pads by their
// folder.
TEST(StageIdioms, ACharacterScriptReceivesItsTouches) {
  for (const char* hears :
       {"character:WaitForChild('Humanoid')", "character:WaitForChild('Left Leg')"}) {
    Scene scene;
    spawn(scene, "SpawnLocation", {0, 0, 50});
    const auto folder = scene.add("Folder", "Places", scene.workspace);
    for (const float x : {30.0f, 120.0f, 60.0f}) scene.part("Part", {x, 0, 0}, folder);
    const auto floor = scene.part("Floor", {0, -20, 0});
    scene.script(
        std::string("game.Players.PlayerAdded:Connect(function(player)\n"
                    " local stats = Instance.new('Folder') stats.Name = 'leaderstats'\n"
                    " stats.Parent = player\n"
                    " local stage = Instance.new('IntValue') stage.Name = 'Stage'\n"
                    " stage.Parent = stats\n"
                    " player.CharacterAdded:Connect(function(character)\n  local hears = ") +
            hears +
            "\n  hears.Touched:Connect(function(hit)\n"
            "   if hit.Parent ~= workspace.Places then return end\n"
            "   stage.Value = table.find(workspace.Places:GetChildren(), hit)\n"
            "  end)\n end)\nend)",
        scene.scripts);
    const auto& level = scene.level();
    ASSERT_EQ(level.spawns.size(), 4u) << hears;
    EXPECT_FLOAT_EQ(level.spawns[1].position.x, 30);
    EXPECT_FLOAT_EQ(level.spawns[2].position.x, 120);
    EXPECT_FLOAT_EQ(level.spawns[3].position.x, 60);
    EXPECT_FALSE(scene[floor].checkpoint);
  }
}

TEST(StageIdioms, ACharacterScriptCanRequireTheNextNumber) {
  Scene scene;
  spawn(scene, "SpawnLocation", {0, 0, 50});
  const auto folder = scene.add("Folder", "Checkpoints", scene.workspace);
  for (const int n : {1, 2, 3, 4}) scene.part(std::to_string(n), {30.0f * float(n), 0, 0}, folder);
  scene.script(
      "game.Players.PlayerAdded:Connect(function(player)\n"
      " local stats = Instance.new('Folder') stats.Name = 'leaderstats' stats.Parent = player\n"
      " local stage = Instance.new('IntValue') stage.Name = 'Stage' stage.Value = 1\n"
      " stage.Parent = stats\n"
      " player.CharacterAdded:Connect(function(character)\n"
      "  local human = character:WaitForChild('Humanoid')\n  wait()\n"
      "  character:MoveTo(workspace.Checkpoints[stage.Value].Position)\n"
      "  human.Touched:Connect(function(hit)\n"
      "   if hit.Parent ~= workspace.Checkpoints then return end\n"
      "   if tonumber(hit.Name) == stage.Value + 1 then stage.Value = stage.Value + 1 end\n"
      "  end)\n end)\nend)",
      scene.scripts);
  EXPECT_EQ(order(scene.level()), (Names{"1", "2", "3", "4"}));
}

TEST(StageIdioms, RespawnPositionsRevealAScriptsTable) {
  Scene scene;
  spawn(scene, "SpawnLocation", {});
  const auto far = scene.part("Far", {60, 0, 0}), near = scene.part("Near", {30, 0, 0}),
             bell = scene.part("Bell", {10, 0, 0});
  scene.script(
      "local last = {}\n"
      "for _, name in { 'Far', 'Near', 'Bell' } do\n"
      " workspace[name].Touched:Connect(function(hit)\n"
      "  local player = game.Players:GetPlayerFromCharacter(hit.Parent)\n"
      "  if player and name ~= 'Bell' then last[player] = workspace[name] end\n"
      " end)\nend\n"
      "game.Players.PlayerAdded:Connect(function(player)\n"
      " player.CharacterAdded:Connect(function(character)\n"
      "  task.wait(0.1)\n"
      "  if last[player] then character:PivotTo(last[player].CFrame + Vector3.new(0, 4, 0)) end\n"
      " end)\nend)",
      scene.scripts);
  EXPECT_EQ(checkpoints(scene.level()), (Names{"Near", "Far"}));
  EXPECT_EQ(scene.evidence(near, "checkpoint"), "players who touched it respawn there");
  EXPECT_FALSE(scene[bell].checkpoint);
  EXPECT_TRUE(scene[far].goal);
}

TEST(StageIdioms, APartConnectedBeforeInsertionIsACheckpoint) {
  Scene scene;
  spawn(scene, "Start", {});
  scene.script(
      "local pad = Instance.new('Part') pad.Name = 'Made' pad.Anchored = true\n"
      "pad.Position = Vector3.new(30, 0, 0)\n"
      "pad.Touched:Connect(function(hit)\n"
      " local player = game.Players:GetPlayerFromCharacter(hit.Parent)\n"
      " if player then player:SetAttribute('Stage', 1) end\nend)\n"
      "pad.Parent = workspace",
      scene.scripts);
  EXPECT_EQ(checkpoints(scene.level()), (Names{"Made"}));
}

TEST(StageIdioms, AHiddenSpawnLocationIsNoSeparateCheckpoint) {
  Scene scene;
  spawn(scene, "Start", {});
  for (const int n : {2, 1}) {
    const std::string name = std::to_string(n);
    const auto pad = scene.part("Flag" + name, {40.0f * float(n), 0, 0});
    spawn(scene, "Spawn" + name, {40.0f * float(n), 0, 8});
    scene.script(
        "script.Parent.Touched:Connect(function(hit)\n"
        " local player = game.Players:GetPlayerFromCharacter(hit.Parent)\n"
        " if player then player.RespawnLocation = workspace.Spawn" +
            name + " end\nend)",
        pad);
  }
  EXPECT_EQ(checkpoints(scene.level()), (Names{"Flag1", "Flag2"}));
}

TEST(StageIdioms, TaggedSpawnLocationsAndTheirPadsAreOneCheckpoint) {
  Scene scene;
  spawn(scene, "Start", {});
  for (const int n : {2, 1}) {
    const auto home = spawn(scene, "Home" + std::to_string(n), {40.0f * float(n), 0, 0});
    scene.tag(home, "Checkpoint");
    scene.script(
        "script.Parent.Touched:Connect(function(hit)\n"
        " local player = game.Players:GetPlayerFromCharacter(hit.Parent)\n"
        " if player then player.RespawnLocation = script.Parent.Parent end\nend)",
        scene.part("Touch", {40.0f * float(n), 1, 0}, home));
  }
  EXPECT_EQ(checkpoints(scene.level()), (Names{"Home1", "Home2"}));
}

TEST(StageIdioms, ATeamAssignedByAPadNumbersIt) {
  for (const char* set : {"player.Team = game.Teams['Level %d']",
                          "player.TeamColor = game.Teams['Level %d'].TeamColor"}) {
    Scene scene;
    spawn(scene, "Start", {});
    const auto teams = scene.add("Teams", "Teams", kNoInstance);
    for (const int n : {0, 1, 2, 3}) {
      const auto team = scene.add("Team", "Level " + std::to_string(n), teams);
      scene.set(team, "TeamColor", int64_t{n == 0 ? 1 : 20 + n});
      scene.set(team, "AutoAssignable", n == 0);
    }
    const char* const names[] = {"", "Red", "Green", "Blue"};
    for (const int n : {1, 2, 3}) {
      std::string line = set;
      line.replace(line.find("%d"), 2, std::to_string(n));
      // Red is the farthest, and the first.
      scene.script(
          "script.Parent.Touched:Connect(function(hit)\n"
          " local player = game.Players:GetPlayerFromCharacter(hit.Parent)\n"
          " if player then " +
              line + " end\nend)",
          scene.part(names[n], {120.0f - 30.0f * float(n), 0, 0}));
    }
    EXPECT_EQ(checkpoints(scene.level()), (Names{"Red", "Green", "Blue"})) << set;
  }
}

TEST(StageIdioms, APadOfThePlayersCurrentStageIsIncluded) {
  Scene scene;
  spawn(scene, "Start", {});
  const auto folder = scene.add("Folder", "Pads", scene.workspace);
  for (const int n : {1, 2, 3})
    scene.value("IntValue", "Stage", int64_t{n},
                scene.part("Part", {30.0f * float(n), 0, 0}, folder));
  scene.script(
      "game.Players.PlayerAdded:Connect(function(player)\n"
      " local stats = Instance.new('Folder') stats.Name = 'leaderstats'\n"
      " stats.Parent = player\n"
      " local stage = Instance.new('IntValue') stage.Name = 'Stage'\n"
      " stage.Value = 1 stage.Parent = stats\nend)\n"
      "for _, pad in workspace.Pads:GetChildren() do\n"
      " pad.Touched:Connect(function(hit)\n"
      "  local player = game.Players:GetPlayerFromCharacter(hit.Parent)\n"
      "  local stage = player and player.leaderstats.Stage\n"
      "  if stage and pad.Stage.Value > stage.Value then stage.Value = pad.Stage.Value end\n"
      " end)\nend",
      scene.scripts);
  const auto& level = scene.level();
  ASSERT_EQ(level.spawns.size(), 4u);
  for (size_t i = 1; i < 4; ++i) EXPECT_FLOAT_EQ(level.spawns[i].position.x, 30.0f * float(i));
}

}  // namespace
}  // namespace obby::test
