// What recordings know of the parameters at a point, from how their errors change around it.
#pragma once

#include <Eigen/Core>

#include "calibrate/objective.h"

namespace obby::calibrate {

// Slopes of all residuals by the coordinates of the point, weighted as the loss weighs them.
struct Slopes {
  Eigen::MatrixXd normal;    // (n, n): J^T W J
  Eigen::VectorXd gradient;  // (n): J^T W r
  Eigen::MatrixXd scatter;   // (n, n): of the gradients of stretches of the recordings
  double noise = 0;          // a residual's deviation, studs
};
Result<Slopes> slopesAt(const Objective& objective, const std::vector<double>& point);

// Half widths of the 95 % intervals and correlations, both in shares of the bounds; a coordinate
// that shows nowhere has a half width of 1.
struct Evidence {
  std::vector<double> half;
  Eigen::MatrixXd correlation;
};
Evidence evidenceOf(const Slopes& slopes);

// Gauss-Newton with a trust region around `point`, as long as the loss falls. The evaluations that
// it took are added.
Result<std::vector<double>> refined(const Objective& objective, std::vector<double> point,
                                    uint64_t& evaluations);

}  // namespace obby::calibrate
