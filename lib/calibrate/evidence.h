// What recordings know of the parameters at a point, from how their errors change around it.
#pragma once

#include <Eigen/Core>

#include "calibrate/objective.h"
#include "calibrate/work.h"

namespace obby::calibrate {

// Slopes of all residuals by the coordinates of the point, weighted as the loss weighs them.
struct Slopes {
  Eigen::MatrixXd normal;    // (n, n): J^T W J
  Eigen::VectorXd gradient;  // (n): J^T W r
  Eigen::MatrixXd scatter;   // (n, n): of the gradients of stretches of the recordings
  double noise = 0;          // a residual's deviation, studs
  double alike = 1;          // frames in a row that count as one sample
};
// Empty after a stop.
Result<Slopes> slopesAt(const Objective& objective, const std::vector<double>& point,
                        const Work& work);

// Half widths of the 95 % intervals and correlations, both in shares of the bounds; a coordinate
// that shows nowhere has a half width of 1.
struct Evidence {
  std::vector<double> half;
  Eigen::MatrixXd correlation;
};
Evidence evidenceOf(const Slopes& slopes);

// Whether a coordinate changes anything that was recorded, between its bounds; `here`: the
// residuals at the point.
bool shows(const Objective& objective, const std::vector<double>& point, size_t coordinate,
           const std::vector<float>& here);

// Studs that the positions are off where the simulator does what was recorded: a middle one of all
// errors, which a window in which something else happened does not move.
Result<double> noiseAt(const Objective& objective, const std::vector<double>& point);

// By how much a loss over so many frames may exceed the least one, before what it belongs to can be
// ruled out with 95 % (the likelihood ratio's chi-square bound, of one degree of freedom).
double slackOf(const Slopes& slopes, size_t frames);

// Gauss-Newton with a trust region around `point`, as long as the loss falls, in so many rounds at
// most. A stop ends it at the best point until then.
Result<std::vector<double>> refined(const Objective& objective, std::vector<double> point,
                                    int rounds, const Work& work);

}  // namespace obby::calibrate
