// The optimiser on functions with a known minimum.
#include "calibrate/cma_es.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace obby::calibrate {
namespace {

using Point = std::vector<double>;

struct Minimum {
  Point best;
  double loss = 1e300;
  uint32_t evaluations = 0;
};

Minimum minimise(const std::function<double(const Point&)>& f, size_t dimensions, double enough) {
  CmaEs method(Point(dimensions, 0.3), 0.3, 16, 1, 0);
  Minimum run;
  std::vector<double> losses(16);
  while (run.loss > enough && run.evaluations < 40000) {
    const auto& points = method.ask();
    for (size_t i = 0; i < points.size(); ++i) {
      for (const double v : points[i]) EXPECT_TRUE(v >= 0 && v <= 1);
      losses[i] = f(points[i]);
      if (losses[i] < run.loss) run.loss = losses[i], run.best = points[i];
    }
    run.evaluations += uint32_t(points.size());
    method.tell(losses);
  }
  return run;
}

// Rosenbrock's function: a bent valley whose floor leads to (0.75, ...).
double rosenbrock(const Point& p) {
  double sum = 0;
  for (size_t i = 0; i + 1 < p.size(); ++i) {
    const double x = 4 * p[i] - 2, y = 4 * p[i + 1] - 2;
    sum += 100 * (y - x * x) * (y - x * x) + (1 - x) * (1 - x);
  }
  return sum;
}

TEST(CmaEs, FindsTheEndOfABentValley) {
  const Minimum run = minimise(rosenbrock, 5, 1e-10);
  EXPECT_LT(run.loss, 1e-10);
  EXPECT_LT(run.evaluations, 8000u);
  for (const double v : run.best) EXPECT_NEAR(v, 0.75, 1e-4);
}

TEST(CmaEs, CopesWithScalesAMillionApart) {
  const Minimum run = minimise(
      [](const Point& p) {
        double sum = 0;
        for (size_t i = 0; i < p.size(); ++i)
          sum += std::pow(10.0, 6 * double(i) / 5) * (p[i] - 0.6) * (p[i] - 0.6);
        return sum;
      },
      6, 1e-10);
  EXPECT_LT(run.loss, 1e-10);
}

TEST(CmaEs, FindsAMinimumInACorner) {
  const Minimum run =
      minimise([](const Point& p) { return p[0] + p[1] + (p[2] - 1) * (p[2] - 1); }, 3, 1e-6);
  EXPECT_LT(run.loss, 1e-6);
}

}  // namespace
}  // namespace obby::calibrate
