// CMA-ES in the unit cube, with an ask-and-tell interface (Hansen, The CMA Evolution Strategy: A
// Tutorial, arXiv 1604.00772). It is written here because the packaged libraries pass Eigen objects
// across their ABI. Our vector width, and with it Eigen's allocator, differs from theirs.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/random.h"

namespace obby::calibrate {

class CmaEs {
 public:
  // `mean` and `deviation` describe the first generation. `population` is at least 4.
  CmaEs(const std::vector<double>& mean, double deviation, uint32_t population, uint64_t seed,
        uint64_t stream);

  // Returns (population) points, each coordinate in [0, 1].
  const std::vector<std::vector<double>>& ask();
  // `losses` belong to the points of the last ask(), in the same order.
  void tell(const std::vector<double>& losses);

  // Returns the largest standard deviation of the next generation. A small one means convergence.
  double spread() const;

 private:
  double normal();

  Eigen::Index n_;
  uint32_t population_;
  Random random_;
  Eigen::VectorXd weights_;
  double best_, cc_, cs_, c1_, cmu_, damping_, expected_;  // best_: effective number of parents
  double deviation_;
  Eigen::VectorXd mean_, pathC_, pathS_, lengths_;  // lengths_: deviations along the principal axes
  Eigen::MatrixXd covariance_, axes_;
  Eigen::MatrixXd drawn_;  // (n, population), before reflection into the cube
  std::vector<std::vector<double>> points_;
  uint64_t generation_ = 0;
};

}  // namespace obby::calibrate
