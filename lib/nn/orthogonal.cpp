#include "nn/orthogonal.h"

#include <Eigen/QR>
#include <algorithm>

#include "nn/normal.h"

namespace obby::nn {

void fillOrthogonal(float* matrix, size_t rows, size_t columns, size_t stride, float gain,
                    Random& random) {
  const auto tall = Eigen::Index(std::max(rows, columns));
  Eigen::MatrixXf draws(tall, Eigen::Index(std::min(rows, columns)));
  for (Eigen::Index i = 0; i < draws.size(); ++i) draws.data()[i] = normal(random);
  const Eigen::HouseholderQR<Eigen::MatrixXf> qr(draws);
  const Eigen::MatrixXf q = qr.householderQ() * Eigen::MatrixXf::Identity(tall, draws.cols());
  for (size_t r = 0; r < rows; ++r) {
    for (size_t c = 0; c < columns; ++c) {
      const auto row = Eigen::Index(r), column = Eigen::Index(c);
      matrix[r * stride + c] = gain * (rows >= columns ? q(row, column) : q(column, row));
    }
  }
}

}  // namespace obby::nn
