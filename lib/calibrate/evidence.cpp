#include "calibrate/evidence.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "calibrate/noise.h"

namespace obby::calibrate {

namespace {

// Step of the finite differences. It is large enough that an event which moves by a tick does not
// look like a gradient, and small against a parameter's interval.
constexpr double kStep = 0.004;
// Seconds of consecutive samples that count as one, since they are not independent.
constexpr double kAlike = 0.5;
// Seconds of frames whose gradients are summed as one stretch. Errors of a window share a cause,
// its first sample.
constexpr double kStretch = 1.5;
// Added to the diagonal of the normal matrix, relative to its largest element, so that the matrix
// can be inverted.
constexpr double kMinEigenvalue = 1e-9;
// Studs. No recorder is more precise: a fall deviates by more between two frames.
constexpr double kMinNoise = 1e-3;
constexpr float kShows = 1e-3f;  // studs by which at least one frame must change

std::vector<double> moved(std::vector<double> point, size_t at, double by) {
  point[at] = std::clamp(point[at] + by, 0.0, 1.0);
  return point;
}

// Returns the variance of one independent sample, as if its frames were fully correlated.
double varianceOf(const Derivatives& s) {
  return std::max(s.noise * s.noise, kMinNoise * kMinNoise) * s.alike;
}

// Returns the mean number of recorded frames in `seconds`, at least 1.
double framesIn(double seconds, const Objective& objective) {
  double all = 0;
  for (const Take& take : objective.takes())
    all += take.track.frames.back().time - take.track.frames.front().time;
  return std::max(std::round(seconds * double(objective.frames()) / all), 1.0);
}

double weightOf(float residual, double near) {
  const double size = double(residual) / near;
  return 1 / (1 + size * size);
}

// `here`: the residuals at the point. If the parameters on one side are invalid, only the other
// side counts.
void writeColumn(const Objective& objective, const std::vector<double>& point,
                 const std::vector<float>& here, int i, Eigen::MatrixXf& jacobian) {
  const auto up = moved(point, size_t(i), kStep), down = moved(point, size_t(i), -kStep);
  const auto above = objective.residuals(up), below = objective.residuals(down);
  const std::vector<float>& high = above ? *above : here;
  const std::vector<float>& low = below ? *below : here;
  const double to = (above ? up : point)[size_t(i)], from = (below ? down : point)[size_t(i)];
  const float width = float(to - from);
  for (Eigen::Index k = 0; k < jacobian.rows(); ++k)
    jacobian(k, i) = width > 0 ? (high[size_t(k)] - low[size_t(k)]) / width : 0.0f;
}

}  // namespace

Result<Derivatives> derivativesAt(const Objective& objective, const std::vector<double>& point,
                                  const Work& work) {
  const Eigen::Index n = Eigen::Index(point.size());
  OBBY_ASSIGN(const std::vector<float> r, objective.residuals(point));
  const Eigen::Index rows = Eigen::Index(r.size());
  Eigen::MatrixXf jacobian(rows, n);
  work.account().count(1);
  work.run(int(n), [&](int i) {
    writeColumn(objective, point, r, i, jacobian);
    work.account().count(2);
  });
  if (work.stopped()) return Derivatives{};
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(n, n);
  Derivatives out{none, Eigen::VectorXd::Zero(n), none, 0, framesIn(kAlike, objective)};
  const Eigen::Index together = Eigen::Index(framesIn(kStretch, objective)) * kResiduals;
  double squares = 0, weights = 0;
  Eigen::VectorXd stretch = Eigen::VectorXd::Zero(n);
  for (Eigen::Index k = 0; k < rows; ++k) {
    const double w = weightOf(r[size_t(k)], objective.settings().near),
                 value = double(r[size_t(k)]);
    const Eigen::VectorXd row = jacobian.row(k).cast<double>();
    out.normal.selfadjointView<Eigen::Lower>().rankUpdate(row, w);
    stretch += w * value * row;
    if (k + 1 == rows || (k + 1) % together == 0) {
      out.gradient += stretch;
      out.scatter += stretch * stretch.transpose();
      stretch.setZero();
    }
    squares += w * value * value;
    weights += w;
  }
  out.normal = Eigen::MatrixXd(out.normal.selfadjointView<Eigen::Lower>());
  out.noise = std::sqrt(squares / std::max(weights, 1.0));
  return out;
}

// A prior with a deviation of half the range stands in for directions that the recordings do not
// determine. Errors differ in size: positions are less precise than facings, and some stretches fit
// worse than others. So the variance is the larger of two: that from the mean residual, and that
// from the disagreement between stretches.
Evidence evidenceOf(const Derivatives& s) {
  const Eigen::Index n = s.normal.rows();
  const double variance = varianceOf(s);
  const Eigen::MatrixXd information =
      s.normal / variance + Eigen::MatrixXd::Identity(n, n) * 4;  // prior: half the range
  const Eigen::MatrixXd covariance = information.ldlt().solve(Eigen::MatrixXd::Identity(n, n));
  const Eigen::MatrixXd inverse = (s.normal + Eigen::MatrixXd::Identity(n, n) * (4 * variance))
                                      .ldlt()
                                      .solve(Eigen::MatrixXd::Identity(n, n));
  const Eigen::MatrixXd disagreement = inverse * s.scatter * inverse;
  Evidence out{std::vector<double>(size_t(n)), Eigen::MatrixXd::Identity(n, n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    out.half[size_t(i)] =
        std::min(1.96 * std::sqrt(std::max(covariance(i, i), disagreement(i, i))), 1.0);
    for (Eigen::Index k = 0; k < n; ++k)
      out.correlation(i, k) = covariance(i, k) / std::sqrt(covariance(i, i) * covariance(k, k));
  }
  return out;
}

bool shows(const Objective& objective, const std::vector<double>& point, size_t coordinate,
           const std::vector<float>& here) {
  for (const double share : {0.15, 0.85}) {
    std::vector<double> moved = point;
    moved[coordinate] = share;
    const auto there = objective.residuals(moved);
    if (!there) continue;  // invalid parameters
    for (size_t k = 0; k < here.size(); ++k) {
      if (std::fabs((*there)[k] - here[k]) > kShows) return true;
    }
  }
  return false;
}

Result<double> noiseAt(const Objective& objective, const std::vector<double>& point) {
  OBBY_ASSIGN(const std::vector<float> all, objective.residuals(point));
  std::vector<float> sizes;
  for (size_t i = 0; i < all.size(); ++i) {
    if (i % kResiduals < 3) sizes.push_back(std::fabs(all[i]));
  }
  const auto middle = sizes.begin() + std::ptrdiff_t(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return kDeviationOfMedian * double(*middle);
}

double slackOf(const Derivatives& derivatives, size_t frames) {
  constexpr double kHalfChiSquare = 1.92;
  return kHalfChiSquare * varianceOf(derivatives) / double(frames);
}

Result<std::vector<double>> refined(const Objective& objective, std::vector<double> point,
                                    int rounds, const Work& work) {
  double loss = objective.loss(point), damping = 1e-3;
  for (int round = 0; round < rounds; ++round) {
    OBBY_ASSIGN(const Derivatives s, derivativesAt(objective, point, work));
    if (work.stopped()) break;
    const double scale = std::max(s.normal.diagonal().maxCoeff() * kMinEigenvalue, 1e-12);
    bool better = false;
    for (int tries = 0; tries < 5 && !better && !work.stopped(); ++tries, damping *= 8) {
      Eigen::MatrixXd damped = s.normal;
      damped.diagonal() += damping * s.normal.diagonal();
      damped.diagonal().array() += scale;
      const Eigen::VectorXd step = damped.ldlt().solve(-s.gradient);
      std::vector<double> next = point;
      for (size_t i = 0; i < next.size(); ++i)
        next[i] = std::clamp(next[i] + std::clamp(step(Eigen::Index(i)), -0.1, 0.1), 0.0, 1.0);
      const double now = objective.loss(next);
      work.account().count(1);
      if (!(now < loss)) continue;
      better = true;
      const bool little = loss - now < 1e-4 * loss;
      loss = now;
      point = std::move(next);
      damping /= 64;
      if (little) return point;
    }
    if (!better) break;
  }
  return point;
}

}  // namespace obby::calibrate
