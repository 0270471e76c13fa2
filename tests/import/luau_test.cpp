// The Luau parser and reader: accepted texts, and inputs that must not crash or hang them.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "engine/luau/lexer.h"
#include "engine/luau/parser.h"
#include "import/scene.h"

namespace obby::test {
namespace {

using luau::parse;

TEST(Luau, BrokenScriptsDoNotRunAndAreNotReported) {
  Scene scene;
  const auto part = scene.part("Part");
  scene.script(
      "local = = 5\nif then\nend )\n"
      "script.Parent.Touched:Connect(function(hit) hit.Parent.Humanoid.Health = 0 end)\n",
      part);
  scene.level();
  EXPECT_FALSE(scene[part].kill);
  EXPECT_EQ(scene.unmodelled("script that fails"), 0u);
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(Luau, HostileScriptsEndSoon) {
  const std::string texts[] = {repeated("(", 100000),
                               "x = " + repeated("a.", 100000) + "b",
                               "x = " + repeated("1 + ", 100000) + "1",
                               "x = " + repeated("{[", 50000),
                               repeated("if x then ", 50000),
                               repeated("function f() ", 50000),
                               "x = " + repeated("-", 100000) + "1",
                               "x = " + repeated("not ", 100000) + "1",
                               "x = " + repeated("if a then b elseif ", 50000),
                               repeated("f(", 50000) + repeated(")", 50000),
                               repeated("x:y():", 50000),
                               "local s = \"" + repeated("\\", 100001),
                               repeated("end ", 100000),
                               repeated("[", 100000),
                               "function f(" + repeated("a: ", 50000),
                               "local x: " + repeated("{", 100000),
                               "local x: " + repeated("...", 300000),
                               std::string(100000, '\0'),
                               repeated("\xff\xfe", 50000)};
  for (const auto& text : texts) (void)parse(text);
}

TEST(Luau, EndlessAndRecursiveScriptsAreReadWithinABudget) {
  const char* const texts[] = {
      "while true do end",
      "while true do print('x') end",
      "function f() return f() end f()",
      "function f() f() f() f() end f()",
      "local t = {} for i = 1, 1e9 do table.insert(t, t) end",
      "for i = 1, 1e9 do for j = 1, 1e9 do x = i * j end end",
      "for i = 1, 10, 0 do end",
      ("for _, a in workspace:GetDescendants() do for _, b in workspace:GetDescendants() do "
       "for _, c in workspace:GetDescendants() do x = a == b end end end"),
      "local function again() task.delay(0, again) end again()",
      "local function again() spawn(again) spawn(again) end again()",
      "workspace.Part.Touched:Connect(function f() end)",
      "local s = 'a' while true do s = s .. s end",
      "local t = {} t.t = t for k, v in pairs(t) do t[k .. 'x'] = v end",
      "repeat task.wait() until false"};
  for (const char* text : texts) {
    Scene scene;
    for (int i = 0; i < 50; ++i) scene.part("Part");
    scene.script(text, scene.scripts);
    EXPECT_EQ(scene.level().parts.size(), 50u);
  }
}

// The script looks up Workspace repeatedly, but a model file has none.
TEST(Luau, ManyRootsAreSearchedOnce) {
  Scene scene = Scene::model();
  for (int i = 0; i < 50000; ++i) scene.add("Folder", "Folder", kNoInstance);
  scene.script("for i = 1, 2000 do for j = 1, 100 do local x = workspace end end", kNoInstance);
  scene.level();
}

// A part that turns on and off at the same moment does not count as a timer.
TEST(Luau, ManySwitchesOfATimerEndSoon) {
  Scene scene;
  const auto part = scene.part("Part");
  scene.script(
      "local p = workspace.Part while true do\n"
      "for i = 1, 300 do for j = 1, 200 do p.CanCollide = false end end\n"
      "p.CanCollide = true wait(1) end",
      scene.scripts);
  scene.level();
  EXPECT_FALSE(scene[part].vanish);
}

TEST(Luau, RepeatedChangesToAModelAreSearchedOnce) {
  Scene scene;
  const auto pad = scene.part("Pad"), model = scene.add("Model", "Model", scene.workspace);
  for (int i = 0; i < 50000; ++i) scene.add("Folder", "Folder", model);
  scene.script(
      "local m = workspace.Model script.Parent.Touched:Connect(function()\n"
      "for i = 1, 500 do for j = 1, 200 do m:Destroy() end end end)",
      pad);
  scene.level();
}

TEST(Luau, BigTablesAndLongTextsEndSoon) {
  std::string fields;
  for (int i = 0; i < 50000; ++i) fields += "a" + std::to_string(i) + " = 1, ";
  const std::string rounds = " for i = 1, 2000 do for j = 1, 2000 do ";
  const std::string texts[] = {
      "local t = {" + fields + "}" + rounds + "for k in pairs(t) do break end end end",
      "local s = '" + std::string(900000, 'x') + "'" + rounds + "local x = s end end",
      "local tags = game:GetService('CollectionService')" + rounds +
          "local n = #tags:GetTagged('Coin') end end"};
  for (const std::string& text : texts) {
    Scene scene;
    for (int i = 0; i < 2000; ++i) scene.tag(scene.part("Part"), "Coin");
    scene.script(text, scene.scripts);
    scene.level();
  }
}

TEST(Luau, CodeAfterAnEndlessLoopDoesNotRun) {
  const char* const loops[] = {"while true do end",
                               "while task.wait(1) do end",
                               "while true do game.RunService.Heartbeat:Wait() end",
                               "repeat task.wait() until false",
                               "while not (1 == 2) do print('x') wait() end",
                               "while math.random() > 0 do p.Transparency = 1 wait() end",
                               "local on = true while on do p.Transparency = 1 wait() end"};
  for (const char* loop : loops) {
    Scene scene;
    const auto part = scene.part("Part");
    scene.script("local p = script.Parent\n" + std::string(loop) +
                     "\np.Touched:Connect(function(h) h.Parent.Humanoid.Health = 0 end)",
                 part);
    scene.level();
    const bool isGuess = scene.evidence(part, "kill").rfind("guessed: ", 0) == 0;
    EXPECT_TRUE(!scene[part].kill || isGuess)
        << loop;  // the text of a script is evidence if the script was stopped
  }
}

// The string reuses the memory of the connections, which was freed when their list grew.
TEST(Luau, ACompletedTweenCanConnectMoreHandlers) {
  Scene scene;
  const auto part = scene.part("Part");
  scene.script(R"(local p = script.Parent
local t = game:GetService("TweenService"):Create(p, TweenInfo.new(1), {Transparency = 1})
t.Completed:Connect(function()
  t.Completed:Connect(function() end)
  local text = "123456789012345678901234567890"
end)
t.Completed:Connect(function()
  p.Touched:Connect(function(h) h.Parent.Humanoid.Health = 0 end)
end)
t:Play())",
               part);
  scene.level();
  EXPECT_TRUE(scene[part].kill);
}

TEST(Luau, ManyPartsUnderOneCentralScript) {
  Scene scene;
  const auto folder = scene.add("Folder", "Kill", scene.workspace);
  std::vector<InstanceId> parts;
  for (int i = 0; i < 20000; ++i) parts.push_back(scene.part("Part", {float(i), 0, 0}, folder));
  scene.script(
      "for _, v in workspace:GetDescendants() do\n if v:IsA('BasePart') then\n"
      "  v.Touched:Connect(function(hit)\n   local h = hit.Parent:FindFirstChild('Humanoid')\n"
      "   if h then h.Health = 0 end\n  end)\n end\nend",
      scene.scripts);
  const auto& level = scene.level();
  for (const auto& part : level.parts) ASSERT_TRUE(part.kill);
  EXPECT_TRUE(level.unmodelled.empty());
}

TEST(Luau, TruncatedAtEveryByte) {
  const std::string text =
      "local ts = game:GetService('TweenService')\nfor i, v in pairs(workspace.Kill:GetChildren()) "
      "do v.Touched:Connect(function(hit: BasePart) if hit then hit.Parent.Humanoid.Health -= 5 "
      "end end) end --[[ x ]] local t = {a = [[b]], ['c'] = `d`}";
  for (size_t size = 0; size <= text.size(); ++size) {
    const auto chunk = parse(text.substr(0, size));
    EXPECT_LE(chunk.body.size(), 4u);
  }
}

TEST(Luau, NumbersOfAnyBaseHaveTheirValue) {
  const std::pair<const char*, double> cases[] = {
      {"0b1010", 10}, {"0B1_1", 3}, {"0x1F", 31}, {"1_000.5", 1000.5}, {".5e1", 5}};
  for (const auto& [text, value] : cases) {
    const auto tokens = luau::tokenize(text);
    ASSERT_EQ(tokens.size(), 2u) << text;
    EXPECT_EQ(tokens[0].number, value) << text;
  }
}

// Each variable keeps its own name.
TEST(Luau, VeryLongNamesAreCut) {
  const auto tokens = luau::tokenize("local " + std::string(900000, 'x') + " = 1");
  ASSERT_EQ(tokens.size(), 5u);
  EXPECT_LE(tokens[1].text.size(), 1000u);
  EXPECT_EQ(tokens[2].text, "=");
}

TEST(Luau, LongStringsKeepTheLineCount) {
  const auto tokens = luau::tokenize("--[[\n\n]]\nlocal s = [[\n\n]]\nx = 1");
  EXPECT_EQ(tokens.front().line, 4);
  EXPECT_EQ(tokens[tokens.size() - 2].line, 7);
}

}  // namespace
}  // namespace obby::test
