// CMA-ES (Hansen, The CMA Evolution Strategy: A Tutorial, arXiv 1604.00772) in the unit cube: ask
// for a generation, tell what came of it. Written here because the packaged libraries hand Eigen
// objects over a border across which vector widths, and with them allocators, differ.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/random.h"

namespace obby::calibrate {

class CmaEs {
 public:
  // `mean`, `deviation`: of the first generation. `population`: at least 4.
  CmaEs(const std::vector<double>& mean, double deviation, uint32_t population, uint64_t seed,
        uint64_t stream);

  // (population) points, each coordinate in [0, 1].
  const std::vector<std::vector<double>>& ask();
  // `losses`: of the points that ask() gave, in their order.
  void tell(const std::vector<double>& losses);

  // Of the next generation: its widest deviation. Small: it has come to rest.
  double spread() const;

 private:
  double normal();

  Eigen::Index n_;
  uint32_t population_;
  Random random_;
  Eigen::VectorXd weights_;
  double best_, cc_, cs_, c1_, cmu_, damping_, expected_;  // best_: effective number of parents
  double deviation_;
  Eigen::VectorXd mean_, pathC_, pathS_, lengths_;  // lengths_: of the axes
  Eigen::MatrixXd covariance_, axes_;
  Eigen::MatrixXd drawn_;  // (n, population), before they were brought back into the cube
  std::vector<std::vector<double>> points_;
  uint64_t generation_ = 0;
};

}  // namespace obby::calibrate
