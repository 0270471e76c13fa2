#include "view/trajectories_model.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/place_xml.h"
#include "view/thinning.h"

namespace obby::view {
namespace {

constexpr float kTubeAboveFeet = 1;                       // studs
constexpr float kThinned = 0.1f, kThinnedAttempt = 0.4f;  // studs
constexpr uint32_t kNeon = 288, kBall = 0, kBlock = 1;    // Enum.Material, Enum.PartType
constexpr uint32_t kSolutionColor = 0xffb81c, kAttemptColor = 0x8a6250, kDeathColor = 0xc81e24,
                   kJumpColor = 0xffffff;

struct Look {
  float width;  // studs
  uint32_t color;
  float transparency;
};

class Writer {
 public:
  std::string whole(const Report& report) {
    out_ = io::kXmlBegin;
    model("Trajectories by obby", [&] {
      for (const QueryEntry& query : report.queries) {
        if (!query.paths.empty()) model(query.id, [&] { trajectories(query); });
      }
    });
    return out_ + io::kXmlEnd;
  }

 private:
  template <class Inside>
  void model(const std::string& name, const Inside& inside) {
    xml_.begin("Model", name);
    xml_.endProperties();
    inside();
    xml_.end();
  }

  void trajectories(const QueryEntry& query) {
    int solutions = 0, attempts = 0;
    for (const PathEntry& path : query.paths) {
      const bool solves = path.kind == PathKind::solution;
      const int number = solves ? ++solutions : ++attempts;
      model(fmt::format("{} {}", solves ? "Solution" : "Attempt", number),
            [&] { trajectory(path, solves); });
    }
  }

  void trajectory(const PathEntry& path, bool solves) {
    const std::vector<Vec3>& feet = path.playback.feet;
    const Look look = solves ? Look{0.35f, kSolutionColor, 0} : Look{0.15f, kAttemptColor, 0.4f};
    const auto at = [&](size_t i) { return feet[i] + Vec3{0, kTubeAboveFeet, 0}; };
    const auto distance = [&](size_t a, size_t b, size_t p) {
      const Vec3 along = feet[b] - feet[a], off = feet[p] - feet[a];
      const float squared = dot(along, along);
      const float t = squared > 0 ? std::clamp(dot(off, along) / squared, 0.0f, 1.0f) : 0;
      return length(off - along * t);
    };
    const std::vector<size_t> kept =
        thinned(feet.size(), solves ? kThinned : kThinnedAttempt, distance);
    for (size_t i = 0; i + 1 < kept.size(); ++i) segment(at(kept[i]), at(kept[i + 1]), look);
    for (const uint32_t tick : path.playback.jumpTicks)
      mark("Jump", at(std::min<size_t>(tick, feet.size() - 1)), kBall, kJumpColor);
    if (!solves && path.playback.outcome != schema::Outcome::RUNNING)
      mark("End", at(feet.size() - 1), kBlock, kDeathColor);
  }

  // Adds a bar whose Z axis runs from a to b.
  void segment(Vec3 a, Vec3 b, const Look& look) {
    const float size = length(b - a);
    if (size < 1e-3f) return;
    const Vec3 z = (b - a) * (1 / size);
    const Vec3 x = normalize(cross(absf(z.y) > 0.99f ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, z));
    part("Segment", (a + b) * 0.5f, {x, cross(z, x), z}, {look.width, look.width, size}, kBlock,
         look);
  }

  void mark(const char* name, Vec3 at, uint32_t shape, uint32_t color) {
    part(name, at, {}, {0.8f, 0.8f, 0.8f}, shape, {0.8f, color, 0});
  }

  void part(const char* name, Vec3 at, const Mat3& axes, Vec3 size, uint32_t shape,
            const Look& look) {
    xml_.begin("Part", name);
    xml_.flag("Anchored", true);
    for (const char* off : {"CanCollide", "CanTouch", "CanQuery", "CastShadow"})
      xml_.flag(off, false);
    xml_.frame("CFrame", at, axes);
    xml_.vector("size", size);
    xml_.color("Color3uint8", look.color);
    xml_.token("Material", kNeon);
    xml_.token("shape", shape);
    xml_.number("Transparency", look.transparency);
    xml_.endProperties();
    xml_.end();
  }

  std::string out_;
  io::PlaceXml xml_{out_};
};

}  // namespace

std::string trajectoriesModel(const Report& report) { return Writer().whole(report); }

}  // namespace obby::view
