#include "tissue/non_negative_least_squares.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <vector>

namespace springcheck::tissue {
namespace {

using Eigen::Index;

/// The entries of x that may be other than 0.
using Free = std::vector<Index>;

/// The column outside `free`, and not refused, along which the residual falls most
/// steeply; -1 where there is none.
Index steepest_column(const Eigen::MatrixXd& A, const Eigen::VectorXd& residual,
                      const Free& free, const Free& refused, double tolerance) {
  const auto has = [](const Free& columns, Index j) {
    return std::find(columns.begin(), columns.end(), j) != columns.end();
  };
  Index steepest = -1;
  double slope = tolerance;
  for (Index j = 0; j < A.cols(); ++j) {
    const double here = A.col(j).dot(residual) / A.col(j).norm();
    if (here > slope && !has(free, j) && !has(refused, j)) {
      slope = here;
      steepest = j;
    }
  }
  return steepest;
}

/// Moves x towards `best`, one entry for each of `free`, as far as none turns negative;
/// one that stops it leaves `free`. Returns whether it got there.
bool move_towards(const Eigen::VectorXd& best, Free& free, Eigen::VectorXd& x) {
  double part = 1;
  Index stopping = -1;
  for (Index k = 0; k < best.size(); ++k) {
    const double from = x[free[static_cast<std::size_t>(k)]];
    if (best[k] <= 0 && from / (from - best[k]) < part) {
      part = from / (from - best[k]);
      stopping = k;
    }
  }
  for (Index k = 0; k < best.size(); ++k) {
    double& value = x[free[static_cast<std::size_t>(k)]];
    value += part * (best[k] - value);
  }
  if (stopping < 0) return true;
  x[free[static_cast<std::size_t>(stopping)]] = 0;
  free.erase(free.begin() + stopping);
  return false;
}

}  // namespace

Eigen::VectorXd non_negative_least_squares(const Eigen::MatrixXd& A,
                                           const Eigen::VectorXd& b) {
  const double tolerance = 1e-13 * b.norm();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(A.cols());
  Free free, refused;
  // These are as many rounds as Lawson and Hanson's own program takes at most, and more.
  for (Index i = 0; i < 10 * A.cols(); ++i) {
    const Index added = steepest_column(A, b - A * x, free, refused, tolerance);
    if (added < 0) return x;
    free.push_back(added);
    const auto best = [&]() -> Eigen::VectorXd {
      return A(Eigen::all, free).householderQr().solve(b);
    };
    Eigen::VectorXd target = best();
    if (target[target.size() - 1] <= 0) {  // its slope was round-off
      free.pop_back();
      refused.push_back(added);
      continue;
    }
    refused.clear();
    while (!move_towards(target, free, x)) target = best();
  }
  return x;
}

}  // namespace springcheck::tissue
