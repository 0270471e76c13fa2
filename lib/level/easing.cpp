// Easing curves by Penner's formulas, which TweenService follows. They are computed once a level on
// the host, in double precision. Rounding hides the last bits, in which mathematics libraries
// differ.
#include <cmath>

#include "level/motion_tables.h"

namespace obby::level {
namespace {

constexpr double kPiD = 3.14159265358979323846;

double bounceOut(double t) {
  constexpr double n = 7.5625, d = 2.75;
  if (t < 1 / d) return n * t * t;
  if (t < 2 / d) return t -= 1.5 / d, n * t * t + 0.75;
  if (t < 2.5 / d) return t -= 2.25 / d, n * t * t + 0.9375;
  return t -= 2.625 / d, n * t * t + 0.984375;
}

// Overshoot of Back and period of Elastic. Both are larger in the halves of InOut.
struct Swing {
  double back, period;
};
constexpr Swing kWhole{1.70158, 0.3}, kHalf{1.70158 * 1.525, 0.45};

double easeIn(schema::Easing easing, double t, const Swing& swing) {
  using schema::Easing;
  switch (easing) {
    case Easing::LINEAR: return t;
    case Easing::SINE: return 1 - std::cos(t * kPiD / 2);
    case Easing::BACK: return t * t * ((swing.back + 1) * t - swing.back);
    case Easing::QUAD: return t * t;
    case Easing::CUBIC: return t * t * t;
    case Easing::QUART: return t * t * t * t;
    case Easing::QUINT: return t * t * t * t * t;
    case Easing::BOUNCE: return 1 - bounceOut(1 - t);
    case Easing::ELASTIC:
      return t <= 0   ? 0
             : t >= 1 ? 1
                      : -std::pow(2, 10 * t - 10) *
                            std::sin((t - 1 - swing.period / 4) * 2 * kPiD / swing.period);
    case Easing::EXPONENTIAL: return t <= 0 ? 0 : std::pow(2, 10 * t - 10);
    case Easing::CIRCULAR: return 1 - std::sqrt(1 - t * t);
  }
  return t;
}

}  // namespace

double ease(schema::Easing easing, schema::EasingDirection direction, double t) {
  double y = t;
  switch (direction) {
    case schema::EasingDirection::IN: y = easeIn(easing, t, kWhole); break;
    case schema::EasingDirection::OUT: y = 1 - easeIn(easing, 1 - t, kWhole); break;
    case schema::EasingDirection::IN_OUT:
      y = t < 0.5 ? easeIn(easing, 2 * t, kHalf) / 2 : 1 - easeIn(easing, 2 - 2 * t, kHalf) / 2;
      break;
  }
  return std::round(y * 1e7) / 1e7;
}

}  // namespace obby::level
