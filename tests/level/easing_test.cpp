// Compares every easing style in every direction with Penner's formula for that direction. Public
// replicas of TweenService use these formulas.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "level/motion_tables.h"

namespace obby::level {
namespace {

using schema::Easing;
using schema::EasingDirection;
using Curve = double (*)(double);

constexpr double kPiD = 3.14159265358979323846;
constexpr double kBack = 1.70158, kBackInOut = 2.5949095;

double power(double base, double exponent) { return std::pow(base, exponent); }

double bounceOut(double t) {
  const double from = t < 4 / 11.0 ? 0 : t < 8 / 11.0 ? 6 : t < 10 / 11.0 ? 9 : 10.5;
  const double floor = t < 4 / 11.0 ? 0 : t < 8 / 11.0 ? 48 : t < 10 / 11.0 ? 60 : 63;
  return power(11 * t - from, 2) / 16 + floor / 64;
}

struct Row {
  Easing easing;
  Curve in, out, inOut;
};

const Row kRows[] = {
    {Easing::LINEAR, [](double t) { return t; }, [](double t) { return t; },
     [](double t) { return t; }},
    {Easing::SINE, [](double t) { return 1 - std::cos(t * kPiD / 2); },
     [](double t) { return std::sin(t * kPiD / 2); },
     [](double t) { return (1 - std::cos(kPiD * t)) / 2; }},
    {Easing::QUAD, [](double t) { return t * t; }, [](double t) { return t * (2 - t); },
     [](double t) { return t < 0.5 ? 2 * t * t : 1 - 2 * (1 - t) * (1 - t); }},
    {Easing::CUBIC, [](double t) { return power(t, 3); },
     [](double t) { return power(t - 1, 3) + 1; },
     [](double t) { return t < 0.5 ? 4 * power(t, 3) : 4 * power(t - 1, 3) + 1; }},
    {Easing::QUART, [](double t) { return power(t, 4); },
     [](double t) { return 1 - power(t - 1, 4); },
     [](double t) { return t < 0.5 ? 8 * power(t, 4) : 1 - 8 * power(t - 1, 4); }},
    {Easing::QUINT, [](double t) { return power(t, 5); },
     [](double t) { return power(t - 1, 5) + 1; },
     [](double t) { return t < 0.5 ? 16 * power(t, 5) : 16 * power(t - 1, 5) + 1; }},
    {Easing::CIRCULAR, [](double t) { return 1 - std::sqrt(1 - t * t); },
     [](double t) { return std::sqrt(1 - (t - 1) * (t - 1)); },
     [](double t) {
       return t < 0.5 ? 0.5 - std::sqrt(0.25 - t * t) : 0.5 + std::sqrt(0.25 - (t - 1) * (t - 1));
     }},
    {Easing::EXPONENTIAL, [](double t) { return power(2, 10 * t - 10); },
     [](double t) { return 1 - power(2, -10 * t); },
     [](double t) { return t < 0.5 ? power(2, 20 * t - 10) / 2 : 1 - power(2, 10 - 20 * t) / 2; }},
    {Easing::BACK, [](double t) { return t * t * (t * (kBack + 1) - kBack); },
     [](double t) { return power(t - 1, 2) * ((t - 1) * (kBack + 1) + kBack) + 1; },
     [](double t) {
       return t < 0.5 ? 2 * t * t * (2 * t * (kBackInOut + 1) - kBackInOut)
                      : power(2 * t - 2, 2) * ((2 * t - 2) * (kBackInOut + 1) + kBackInOut) / 2 + 1;
     }},
    {Easing::ELASTIC,
     [](double t) { return -power(2, 10 * t - 10) * std::sin(2 * kPiD * (t - 1.075) / 0.3); },
     [](double t) { return power(2, -10 * t) * std::sin(2 * kPiD * (t - 0.075) / 0.3) + 1; },
     [](double t) {
       const double wave = std::sin(2 * kPiD * (2 * t - 1.1125) / 0.45) / 2;
       return t < 0.5 ? -power(2, 20 * t - 10) * wave : power(2, 10 - 20 * t) * wave + 1;
     }},
    {Easing::BOUNCE, [](double t) { return 1 - bounceOut(1 - t); }, bounceOut,
     [](double t) {
       return t < 0.5 ? (1 - bounceOut(1 - 2 * t)) / 2 : (1 + bounceOut(2 * t - 1)) / 2;
     }},
};

TEST(Easing, EveryStyleFollowsItsFormulaInEveryDirection) {
  EXPECT_EQ(std::size(kRows), size_t(Easing::CUBIC) + 1);
  for (const Row& row : kRows) {
    for (int i = 1; i < 200; ++i) {
      const double t = i / 200.0;
      const int style = int(row.easing);
      EXPECT_NEAR(ease(row.easing, EasingDirection::IN, t), row.in(t), 1e-6) << style << " " << t;
      EXPECT_NEAR(ease(row.easing, EasingDirection::OUT, t), row.out(t), 1e-6) << style << " " << t;
      EXPECT_NEAR(ease(row.easing, EasingDirection::IN_OUT, t), row.inOut(t), 1e-6)
          << style << " " << t;
    }
  }
}

TEST(Easing, BackOvershootsByATenthInBothDirections) {
  double min = 1, minIn = 1;
  for (int i = 0; i < 1000; ++i) {
    min = std::min(min, ease(Easing::BACK, EasingDirection::IN_OUT, i / 1000.0));
    minIn = std::min(minIn, ease(Easing::BACK, EasingDirection::IN, i / 1000.0));
  }
  EXPECT_NEAR(min, -0.1, 1e-3);
  EXPECT_NEAR(minIn, -0.1, 1e-3);
}

}  // namespace
}  // namespace obby::level
