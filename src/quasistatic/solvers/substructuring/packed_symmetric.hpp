#pragma once

#include <vector>

#include <Eigen/Dense>

namespace breccia::quasistatic {

/// A symmetric matrix of which only the lower triangle is stored, row by row.
template <class Real>
class PackedSymmetric {
 public:
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

  PackedSymmetric() = default;
  explicit PackedSymmetric(const Eigen::MatrixXd& full) : size_(full.rows()) {
    entries_.reserve(static_cast<std::size_t>(size_ * (size_ + 1) / 2));
    for (Eigen::Index i = 0; i < size_; ++i) {
      for (Eigen::Index j = 0; j <= i; ++j) entries_.push_back(static_cast<Real>(full(i, j)));
    }
  }

  [[nodiscard]] Eigen::Index size() const noexcept { return size_; }

  /// y = A x
  void multiply(const Vector& x, Vector& y) const {
    y.setZero(size_);
    const Real* row = entries_.data();
    for (Eigen::Index i = 0; i < size_; row += ++i) {
      const Eigen::Map<const Vector> before(row, i);
      y[i] += before.dot(x.head(i)) + row[i] * x[i];
      y.head(i) += x[i] * before;
    }
  }

  [[nodiscard]] Eigen::MatrixXd full() const {
    Eigen::MatrixXd matrix(size_, size_);
    auto entry = entries_.begin();
    for (Eigen::Index i = 0; i < size_; ++i) {
      for (Eigen::Index j = 0; j <= i; ++j) matrix(i, j) = matrix(j, i) = static_cast<double>(*entry++);
    }
    return matrix;
  }

 private:
  Eigen::Index size_ = 0;
  std::vector<Real> entries_;
};

}  // namespace breccia::quasistatic
