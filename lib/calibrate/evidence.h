// Measures how well recordings determine the parameters at a point, from the residuals' gradients.
#pragma once

#include <Eigen/Core>

#include "calibrate/objective.h"
#include "calibrate/work.h"

namespace obby::calibrate {

// Gradients of all residuals with respect to the point's coordinates, weighted as in the loss.
struct Derivatives {
  Eigen::MatrixXd normal;    // (n, n): J^T W J
  Eigen::VectorXd gradient;  // (n): J^T W r
  Eigen::MatrixXd scatter;   // (n, n): sum of outer products of the gradients per stretch
  double noise = 0;          // standard deviation of a residual, studs
  double alike = 1;          // consecutive frames that count as one independent sample
};
// Returns empty matrices after a stop.
Result<Derivatives> derivativesAt(const Objective& objective, const std::vector<double>& point,
                                  const Work& work);

// Half widths of the 95 % intervals, and correlations, both in shares of the bounds. A coordinate
// without any effect has a half width of about 1.
struct Evidence {
  std::vector<double> half;
  Eigen::MatrixXd correlation;
};
Evidence evidenceOf(const Derivatives& derivatives);

// Returns true if changing the coordinate within its bounds changes any residual. `here`: the
// residuals at `point`.
bool shows(const Objective& objective, const std::vector<double>& point, size_t coordinate,
           const std::vector<float>& here);

// Returns the typical position error in studs, estimated robustly from the median. A window in
// which another event happened hardly changes it.
Result<double> noiseAt(const Objective& objective, const std::vector<double>& point);

// Returns how far a loss over `frames` frames may exceed the minimum before its point is ruled out
// with 95 % confidence. This is the chi-square bound of the likelihood ratio for one degree of
// freedom.
double slackOf(const Derivatives& derivatives, size_t frames);

// Runs up to `rounds` rounds of Gauss-Newton with a trust region, until the loss no longer falls.
// After a stop it returns the best point so far.
Result<std::vector<double>> refined(const Objective& objective, std::vector<double> point,
                                    int rounds, const Work& work);

}  // namespace obby::calibrate
