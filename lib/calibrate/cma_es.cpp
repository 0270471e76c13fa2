#include "calibrate/cma_es.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace obby::calibrate {

// Names and defaults follow table 1 of the tutorial.
CmaEs::CmaEs(const std::vector<double>& mean, double deviation, uint32_t population, uint64_t seed,
             uint64_t stream)
    : n_(Eigen::Index(mean.size())),
      population_(population),
      random_(seed, stream),
      weights_(population / 2),
      deviation_(deviation),
      mean_(Eigen::Map<const Eigen::VectorXd>(mean.data(), n_)),
      pathC_(Eigen::VectorXd::Zero(n_)),
      pathS_(Eigen::VectorXd::Zero(n_)),
      lengths_(Eigen::VectorXd::Ones(n_)),
      covariance_(Eigen::MatrixXd::Identity(n_, n_)),
      axes_(Eigen::MatrixXd::Identity(n_, n_)),
      drawn_(n_, population),
      points_(population, mean) {
  const double n = double(n_), parents = double(weights_.size());
  for (Eigen::Index i = 0; i < weights_.size(); ++i)
    weights_(i) = std::log(parents + 0.5) - std::log(double(i) + 1);
  weights_ /= weights_.sum();
  best_ = 1 / weights_.squaredNorm();
  cc_ = (4 + best_ / n) / (n + 4 + 2 * best_ / n);
  cs_ = (best_ + 2) / (n + best_ + 5);
  c1_ = 2 / ((n + 1.3) * (n + 1.3) + best_);
  cmu_ = std::min(1 - c1_, 2 * (best_ - 2 + 1 / best_) / ((n + 2) * (n + 2) + best_));
  damping_ = 1 + 2 * std::max(0.0, std::sqrt((best_ - 1) / (n + 1)) - 1) + cs_;
  expected_ = std::sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n));
}

// Box-Muller transform of two uniform draws that are never 0.
double CmaEs::normal() {
  const double u = (double(random_.next()) + 0.5) * 0x1p-32;
  const double v = (double(random_.next()) + 0.5) * 0x1p-32;
  return std::sqrt(-2 * std::log(u)) * std::cos(6.283185307179586 * v);
}

const std::vector<std::vector<double>>& CmaEs::ask() {
  Eigen::VectorXd z(n_);
  for (uint32_t k = 0; k < population_; ++k) {
    for (Eigen::Index i = 0; i < n_; ++i) z(i) = normal();
    drawn_.col(k) = mean_ + deviation_ * (axes_ * lengths_.cwiseProduct(z));
    // Reflects the point at the cube's walls, since the optimum may lie on a wall.
    for (Eigen::Index i = 0; i < n_; ++i) {
      double v = drawn_(i, k);
      if (v < 0) v = std::min(-v, 1.0);
      if (v > 1) v = std::max(2 - v, 0.0);
      drawn_(i, k) = v;
      points_[k][size_t(i)] = v;
    }
  }
  return points_;
}

void CmaEs::tell(const std::vector<double>& losses) {
  std::vector<uint32_t> order(population_);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](uint32_t a, uint32_t b) { return losses[a] < losses[b]; });
  ++generation_;
  const Eigen::VectorXd before = mean_;
  mean_.setZero();
  for (Eigen::Index i = 0; i < weights_.size(); ++i)
    mean_ += weights_(i) * drawn_.col(order[size_t(i)]);
  const Eigen::VectorXd step = (mean_ - before) / deviation_;
  const Eigen::VectorXd whitened = axes_ * (axes_.transpose() * step).cwiseQuotient(lengths_);
  pathS_ = (1 - cs_) * pathS_ + std::sqrt(cs_ * (2 - cs_) * best_) * whitened;
  const double faded = 1 - std::pow(1 - cs_, 2 * double(generation_));
  const bool straight = pathS_.norm() / std::sqrt(faded) < (1.4 + 2 / (double(n_) + 1)) * expected_;
  pathC_ = (1 - cc_) * pathC_;
  if (straight) pathC_ += std::sqrt(cc_ * (2 - cc_) * best_) * step;
  const double lost = straight ? 0 : c1_ * cc_ * (2 - cc_);
  covariance_ *= 1 - c1_ - cmu_ + lost;
  covariance_ += c1_ * pathC_ * pathC_.transpose();
  for (Eigen::Index i = 0; i < weights_.size(); ++i) {
    const Eigen::VectorXd y = (drawn_.col(order[size_t(i)]) - before) / deviation_;
    covariance_ += cmu_ * weights_(i) * y * y.transpose();
  }
  deviation_ *= std::exp(std::min(1.0, cs_ / damping_ * (pathS_.norm() / expected_ - 1)));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance_);
  axes_ = solver.eigenvectors();
  lengths_ = solver.eigenvalues().cwiseMax(1e-20).cwiseSqrt();
}

double CmaEs::spread() const { return deviation_ * lengths_.maxCoeff(); }

}  // namespace obby::calibrate
