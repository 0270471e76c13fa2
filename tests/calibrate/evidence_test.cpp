// Tests how certain a parameter is, given recordings at any frame rate.
#include "calibrate/evidence.h"

#include <gtest/gtest.h>

#include "calibrate/course.h"

namespace obby::calibrate {
namespace {

// Returns noisy recordings that stay far from the box and have no poses of parts.
std::vector<Take> plainTakes() {
  std::vector<Take> out = takesUnder(
      defaults(), 0.05f, manoeuvresNamed({"jump on the spot", "walk up a 21-degree ramp"}));
  for (Take& take : out) {
    take.track.shown.clear();
    take.track.parts.clear();
    take.track.poses.clear();
  }
  return out;
}

Frame amid(const Frame& a, const Frame& b) {
  Frame out = a;
  out.time = 0.5 * (a.time + b.time);
  out.position = a.position + (b.position - a.position) * 0.5f;
  out.velocity = a.velocity + (b.velocity - a.velocity) * 0.5f;
  out.facing = a.facing + (b.facing - a.facing) * 0.5f;
  return out;
}

// Adds a frame between each two frames, with the mean of its neighbours. The added frames carry no
// information.
std::vector<Take> ofTwiceTheRate(std::vector<Take> takes) {
  for (Take& take : takes) {
    const std::vector<Frame> before = take.track.frames;
    take.track.frames = {before.front()};
    for (size_t i = 1; i < before.size(); ++i) {
      take.track.frames.push_back(amid(before[i - 1], before[i]));
      take.track.frames.push_back(before[i]);
    }
  }
  return takes;
}

std::vector<double> halfWidths(const std::vector<Take>& takes,
                               const std::vector<std::string>& names) {
  Undisturbed hands;
  const Objective objective(takes, *parametersNamed(names, defaults()), defaults(), {});
  const auto derivatives = derivativesAt(objective, objective.start(), hands.work);
  EXPECT_TRUE(derivatives) << derivatives.error().text();
  return evidenceOf(*derivatives).half;
}

TEST(Evidence, InterpolatedFramesAddNoCertainty) {
  const std::vector<std::string> names = {"walkSpeed", "gravity"};
  const std::vector<Take> takes = plainTakes();
  const std::vector<double> once = halfWidths(takes, names);
  const std::vector<double> twice = halfWidths(ofTwiceTheRate(takes), names);
  for (size_t i = 0; i < names.size(); ++i) {
    ASSERT_LT(once[i], 0.5) << names[i];
    EXPECT_GT(twice[i], 0.75 * once[i]) << names[i];
    EXPECT_LT(twice[i], 1.25 * once[i]) << names[i];
  }
}

// With these steps, a stiffer body would be unstable and its level would not compile.
TEST(Evidence, TheGradientNextToAnInvalidBodyIsOneSided) {
  io::RecordBuilder stiff;
  auto now = stiff.root().initParams();
  setValue(now, "hoverDamping", 200);
  const std::vector<Take> takes = takesUnder(defaults(), 0, manoeuvresNamed({"jump on the spot"}));
  const std::vector<Parameter> damping = *parametersNamed({"hoverDamping"}, now.asReader());
  const Objective objective(takes, damping, now.asReader(), {});
  std::vector<double> point = objective.start();
  point[0] = shareOf(damping[0], 479.5);
  ASSERT_TRUE(objective.residuals(point));
  std::vector<double> shifted = point;
  shifted[0] += 0.004;
  ASSERT_FALSE(objective.residuals(shifted));
  Undisturbed hands;
  const auto derivatives = derivativesAt(objective, point, hands.work);
  ASSERT_TRUE(derivatives) << derivatives.error().text();
  EXPECT_GT(derivatives->normal(0, 0), 0);
}

}  // namespace
}  // namespace obby::calibrate
