#include "gen/place/place_scripts.h"

#include <fmt/format.h>

namespace obby::gen {

namespace {

constexpr const char* kKill = R"(script.Parent.Touched:Connect(function(hit)
	local humanoid = hit.Parent:FindFirstChildOfClass("Humanoid")
	if humanoid then
		humanoid.Health = 0
	end
end)
)";

constexpr const char* kCheckpoints =
    R"(local CollectionService = game:GetService("CollectionService")
local Players = game:GetService("Players")
local last = {}
for _, pad in CollectionService:GetTagged("Checkpoint") do
	pad.Touched:Connect(function(hit)
		local player = Players:GetPlayerFromCharacter(hit.Parent)
		if player then
			last[player] = pad
		end
	end)
end
Players.PlayerAdded:Connect(function(player)
	player.CharacterAdded:Connect(function(character)
		local pad = last[player]
		if pad then
			task.wait()
			local at = pad.Position + Vector3.new(0, 4, 0)
			character:PivotTo(CFrame.lookAt(at, at + pad.CFrame.LookVector))
		end
	end)
end)
)";

std::string vectorText(Vec3 v) { return fmt::format("Vector3.new({}, {}, {})", v.x, v.y, v.z); }

std::string padScript(const PartSketch& part) {
  return fmt::format(R"(script.Parent.Touched:Connect(function(hit)
	local root = hit.Parent:FindFirstChild("HumanoidRootPart")
	if root then
		local v = root.AssemblyLinearVelocity
		root.AssemblyLinearVelocity = Vector3.new(v.X, {}, v.Z)
	end
end)
)",
                     part.pad.y);
}

std::string touchScript(const VanishSketch& v) {
  return fmt::format(R"(local part = script.Parent
local busy = false
part.Touched:Connect(function(hit)
	if busy or not hit.Parent:FindFirstChildOfClass("Humanoid") then
		return
	end
	busy = true
	task.wait({})
	part.CanCollide = false
	part.Transparency = 0.8
	task.wait({})
	part.CanCollide = true
	part.Transparency = 0
	busy = false
end)
)",
                     v.delay, v.away);
}

std::string timerScript(const VanishSketch& v) {
  const bool away = v.phase >= v.delay;  // begins without collision
  const auto half = [](bool solid, float seconds) {
    return fmt::format("\tpart.CanCollide = {}\n\tpart.Transparency = {}\n\ttask.wait({})\n",
                       solid ? "true" : "false", solid ? "0" : "0.8", seconds);
  };
  return "local part = script.Parent\nwhile true do\n" + half(!away, away ? v.away : v.delay) +
         half(away, away ? v.delay : v.away) + "end\n";
}

std::string tweenScript(const MotionSketch& m, Vec3 shift) {
  return fmt::format(R"(local TweenService = game:GetService("TweenService")
local info = TweenInfo.new({}, Enum.EasingStyle.{}, Enum.EasingDirection.InOut, -1, true)
TweenService:Create(script.Parent, info, {{Position = {}}}):Play()
)",
                     m.keys.back().time, m.smooth ? "Sine" : "Linear",
                     vectorText(m.keys.back().position + shift));
}

std::string carrierScript(const MotionSketch& m, Vec3 shift) {
  return fmt::format(R"(local align = script.Parent.AlignPosition
while true do
	align.Position = {1}
	task.wait({0})
	align.Position = {2}
	task.wait({0})
end
)",
                     m.keys.back().time, vectorText(m.keys.back().position + shift),
                     vectorText(m.keys.front().position + shift));
}

std::string spinScript(const MotionSketch& m) {
  const Vec3 a = m.spinAxis * m.spin, p = m.spinPivot;
  const std::string turn = fmt::format("CFrame.Angles({} * dt, {} * dt, {} * dt)", a.x, a.y, a.z);
  std::string pose = "part.CFrame * " + turn;
  if (!(p == Vec3{})) {
    pose = fmt::format("part.CFrame * CFrame.new({}, {}, {}) * {} * CFrame.new({}, {}, {})", p.x,
                       p.y, p.z, turn, -p.x, -p.y, -p.z);
  }
  return "local part = script.Parent\n"
         "game:GetService(\"RunService\").Heartbeat:Connect(function(dt)\n\tpart.CFrame = " +
         pose + "\nend)\n";
}

std::string buttonScript(const PartSketch& button, const std::vector<PartSketch>& parts) {
  std::string there, back;
  for (const PartSketch& p : parts) {
    if (!p.vanish || p.signal != button.signal) continue;
    const bool solid = p.vanish->inverted;
    const auto set = [&p](bool on) {
      return fmt::format("\tlevel[\"{0}\"].CanCollide = {1}\n\tlevel[\"{0}\"].Transparency = {2}\n",
                         p.name, on ? "true" : "false", on ? "0" : "0.8");
    };
    there += set(solid);
    back += set(!solid);
  }
  return fmt::format(R"(local level = script.Parent.Parent
local busy = false
script.Parent.Touched:Connect(function(hit)
	if busy or not hit.Parent:FindFirstChildOfClass("Humanoid") then
		return
	end
	busy = true
{}	task.wait({})
{}	busy = false
end)
)",
                     there, button.button->seconds, back);
}

}  // namespace

std::vector<PlaceScript> scriptsOf(const PartSketch& part, const std::vector<PartSketch>& parts,
                                   Vec3 shift) {
  std::vector<PlaceScript> out;
  if (part.kill) out.push_back({"Kill", kKill});
  if (!(part.pad == Vec3{})) out.push_back({"Launch", padScript(part)});
  if (part.vanish && part.vanish->trigger == schema::VanishTrigger::TOUCH) {
    out.push_back({"Fade", touchScript(*part.vanish)});
  }
  if (part.vanish && part.vanish->trigger == schema::VanishTrigger::TIMER) {
    out.push_back({"Beat", timerScript(*part.vanish)});
  }
  if (part.motion && !part.motion->keys.empty()) {
    out.push_back({"Move", part.motion->carries ? carrierScript(*part.motion, shift)
                                                : tweenScript(*part.motion, shift)});
  }
  if (part.motion && part.motion->spin != 0) out.push_back({"Spin", spinScript(*part.motion)});
  if (part.button) out.push_back({"Press", buttonScript(part, parts)});
  return out;
}

PlaceScript checkpointScript() { return {"Checkpoints", kCheckpoints}; }

}  // namespace obby::gen
