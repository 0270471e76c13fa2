// Hostile scripts end within their budgets, are named in the problems, and do not disturb other
// scripts.
#include <gtest/gtest.h>

#include <chrono>

#include "engine/observe.h"
#include "engine/place.h"

namespace obby::test {
namespace {

struct Hostile {
  const char* name;
  const char* source;
};

const Hostile kScripts[] = {
    {"endless loop", "while true do end"},
    {"endless loop in pcall", "while true do pcall(function() while true do end end) end"},
    {"endless loop each frame",
     "game:GetService('RunService').Heartbeat:Connect(function() while true do end end)"},
    {"memory by a table", "local t = {} while true do t[#t + 1] = {} end"},
    {"memory in pcall",
     "local t = {} while true do pcall(function() t[#t + 1] = string.rep('x', 1e6) .. #t end) end"},
    {"huge string", "local s = string.rep('x', 1e9)"},
    {"doubling string", "local s = 'x' while true do s = s .. s end"},
    {"deep recursion", "local function f() return 1 + f() end f()"},
    {"recursion by metatables",
     "local t = setmetatable({}, {}) getmetatable(t).__index = function(_, k) return t[k .. 'x'] "
     "end print(t.a)"},
    {"nested coroutines", "local function f() coroutine.wrap(f)() end f()"},
    {"pattern bomb", "string.find(string.rep('a', 5000), string.rep('a*', 50) .. 'b')"},
    {"event that fires itself",
     "local e = Instance.new('BindableEvent') e.Event:Connect(function() e:Fire() end) e:Fire()"},
    {"threads without end", "local function f() task.spawn(f) task.defer(f) end f()"},
    {"instances without end", "while true do Instance.new('Part', workspace) end"},
    {"copies of itself", "while true do script:Clone().Parent = workspace end"},
    {"looks into the runtime", "getfenv(0).host.exit() getfenv(print).use('boot').frame = nil"},
    {"breaks an instance", "rawset(workspace, 1, nil) table.remove(workspace, 1)"},
    {"breaks a signal", "rawset(game:GetService('RunService').Heartbeat, 1, nil)"},
    {"error that bites",
     "error(setmetatable({}, {__tostring = function() while true do end end}))"},
    {"code of its own",
     "loadstring('while true do end')() load('x') require('os') io.open('/etc/passwd')"},
    {"compiled code", "\x1bLua"},
    {"wide table.create", "table.create(1e9, 0)"},
    {"unpack without end", "print(unpack({}, 1, 1e8))"},
    {"sort that lies",
     "local t = {} for i = 1, 1000 do t[i] = i end table.sort(t, function() return true end)"},
};

TEST(Hostile, EndsNamesTheScriptAndSparesOthers) {
  for (const Hostile& hostile : kScripts) {
    Place place;
    const InstanceId bad = place.script(hostile.source, place.workspace);
    const InstanceId lava = place.part("Lava", {20, 0, 0});
    place.script("script.Parent.Touched:Connect(function(hit) hit.Parent.Humanoid.Health = 0 end)",
                 lava);
    const auto start = std::chrono::steady_clock::now();
    engine::Plan plan;
    plan.seconds = 5;
    const engine::Report report = engine::observe(place.document, plan);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    EXPECT_LT(took.count(), 25) << hostile.name;
    bool named = false;
    for (const engine::Problem& problem : report.undisturbed.problems)
      named = named || problem.script == bad;
    EXPECT_TRUE(named) << hostile.name << ": " << report.failure;
    bool kills = false;
    for (const engine::Probe& probe : report.probes)
      kills = kills || (probe.target == lava && !probe.seen.harms.empty());
    EXPECT_TRUE(kills) << hostile.name << ": " << report.failure << " "
                       << problems(report.undisturbed);
  }
}

TEST(Hostile, NamesEachOfSeveralScripts) {
  Place place;
  const InstanceId bad[] = {
      place.script("local t = {} while true do t[#t + 1] = {} end", place.workspace),
      place.script("while true do Instance.new('Part', workspace) end", place.workspace)};
  engine::Plan plan;
  plan.seconds = 5;
  const engine::Report report = engine::observe(place.document, plan);
  for (const InstanceId script : bad) {
    bool named = false;
    for (const engine::Problem& problem : report.undisturbed.problems)
      named = named || problem.script == script;
    EXPECT_TRUE(named) << script << ": " << report.failure << " " << problems(report.undisturbed);
  }
}

TEST(Hostile, TheSamePlaceGivesTheSameReport) {
  Place place;
  const InstanceId part = place.part("Spinner", {10, 5, 0});
  place.script(
      "local keys = {} for i = 1, 20 do keys[{}] = i keys['k' .. i] = i keys[function() end] = i "
      "end\n"
      "local sum = 0 for k, v in pairs(keys) do sum = sum * 1.01 + v end\n"
      "while true do script.Parent.CFrame *= CFrame.Angles(0, sum, math.random()) task.wait() end",
      part);
  engine::Plan plan;
  plan.seconds = 5;
  const engine::Report a = engine::observe(place.document, plan);
  const engine::Report b = engine::observe(place.document, plan);
  ASSERT_TRUE(a.undisturbed.tracks.contains(part));
  const auto& first = a.undisturbed.tracks.at(part).poses;
  const auto& second = b.undisturbed.tracks.at(part).poses;
  ASSERT_EQ(first.size(), second.size());
  for (size_t i = 0; i < first.size(); ++i)
    EXPECT_TRUE(first[i].pose.rotation.x == second[i].pose.rotation.x) << i;
}

}  // namespace
}  // namespace obby::test
