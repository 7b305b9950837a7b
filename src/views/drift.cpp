#include "views/drift.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/quantile.hpp"

namespace rva {
namespace {

constexpr int block_px = 32;
constexpr std::size_t least_in_block = block_px * block_px / 8;  // a quarter of the pixels that are sampled
constexpr std::size_t least_blocks = 2 * Drift::terms;

struct Blocks {
  Eigen::MatrixXd terms;      // one row per block
  Eigen::VectorXd change_px;  // medians
};

// Samples every other pixel, as on a chessboard, since neighbouring pixels are correlated.
std::vector<float> changes_in_block(const DisparityChange& change, int left, int top) {
  const int right = std::min(left + block_px, change.judged.width());
  const int bottom = std::min(top + block_px, change.judged.height());
  std::vector<float> changes_px;
  changes_px.reserve(block_px * block_px / 2);
  for (int v = top; v < bottom; ++v) {
    for (int u = left + v % 2; u < right; u += 2) {
      if (change.judged(u, v) != 0) changes_px.push_back(change.after_px(u, v) - change.before_px(u, v));
    }
  }
  return changes_px;
}

Blocks block_medians(const DisparityChange& change, const Drift& drift) {
  std::vector<Drift::Terms> terms;
  std::vector<double> medians_px;
  for (int top = 0; top < change.judged.height(); top += block_px) {
    for (int left = 0; left < change.judged.width(); left += block_px) {
      std::vector<float> changes_px = changes_in_block(change, left, top);
      if (changes_px.size() < least_in_block) continue;
      terms.push_back(drift.terms_at(left + 0.5 * (block_px - 1), top + 0.5 * (block_px - 1)));
      medians_px.push_back(quantile(changes_px, 0.5));
    }
  }
  const auto count = static_cast<Eigen::Index>(terms.size());
  Blocks blocks{Eigen::MatrixXd(count, Drift::terms), Eigen::VectorXd(count)};
  for (Eigen::Index row = 0; row < count; ++row) {
    const auto i = static_cast<std::size_t>(row);
    blocks.terms.row(row) = terms[i].transpose();
    blocks.change_px[row] = medians_px[i];
  }
  return blocks;
}

double deviation_of(const Eigen::VectorXd& residuals) {
  std::vector<double> sizes(static_cast<std::size_t>(residuals.size()));
  std::ranges::transform(residuals, sizes.begin(), [](double residual) { return std::abs(residual); });
  return robust_deviation(sizes);
}

// Tukey's weights, tuned to 95 % of the efficiency of least squares for normal residuals.
// Equation 12 of docs/math.md.
Eigen::VectorXd biweights(const Eigen::VectorXd& residuals, double deviation) {
  constexpr double tuning = 4.685;
  return residuals.unaryExpr([&](double residual) {
    const double share = residual / (tuning * deviation);
    return std::abs(share) < 1.0 ? std::pow(1.0 - share * share, 2) : 0.0;
  });
}

}  // namespace

Drift::Drift(int width, int height, const Terms& coefficients_px, const Covariance& covariance_px2)
    : width_(width),
      height_(height),
      center_u_(0.5 * (width - 1)),
      center_v_(0.5 * (height - 1)),
      scale_(2.0 / std::max(width, height)),
      coefficients_px_(coefficients_px),
      covariance_px2_(covariance_px2) {}

double Drift::x_of(double u) const { return (u - center_u_) * scale_; }

Drift::RowTerms Drift::row_terms(double v) const {
  const double y = (v - center_v_) * scale_;
  return {Terms{1.0, 0.0, y, 0.0, 0.0, y * y}, Terms{0.0, 1.0, 0.0, 0.0, y, 0.0},
          Terms{0.0, 0.0, 0.0, 1.0, 0.0, 0.0}};
}

Drift::Terms Drift::terms_at(double u, double v) const {
  const RowTerms row = row_terms(v);
  const double x = x_of(u);
  return row.a + x * row.b + x * x * row.c;
}

// Along a row the terms are a + b x + c x^2, so both images are polynomials in x.
// Equation 11 of docs/math.md.
Image<float> Drift::px() const {
  Image<float> image(width_, height_);
  for (int v = 0; v < height_; ++v) {
    const RowTerms row = row_terms(v);
    const double constant = row.a.dot(coefficients_px_);
    const double linear = row.b.dot(coefficients_px_);
    const double square = row.c.dot(coefficients_px_);
    for (int u = 0; u < width_; ++u) {
      const double x = x_of(u);
      image(u, v) = static_cast<float>(constant + x * (linear + x * square));
    }
  }
  return image;
}

// Equation 13 of docs/math.md.
Image<float> Drift::variance_px2() const {
  Image<float> image(width_, height_);
  for (int v = 0; v < height_; ++v) {
    const RowTerms row = row_terms(v);
    const auto of = [&](const Terms& p, const Terms& q) { return p.dot(covariance_px2_ * q); };
    const std::array<double, 5> k{of(row.a, row.a), 2.0 * of(row.a, row.b),
                                  of(row.b, row.b) + 2.0 * of(row.a, row.c), 2.0 * of(row.b, row.c),
                                  of(row.c, row.c)};
    for (int u = 0; u < width_; ++u) {
      const double x = x_of(u);
      image(u, v) = static_cast<float>(k[0] + x * (k[1] + x * (k[2] + x * (k[3] + x * k[4]))));
    }
  }
  return image;
}

// Equations 11 to 13 of docs/math.md.
Drift fit_drift(const DisparityChange& change) {
  const int width = change.judged.width();
  const int height = change.judged.height();
  Drift none(width, height, Drift::Terms::Zero(), Drift::Covariance::Zero());
  const Blocks blocks = block_medians(change, none);
  if (static_cast<std::size_t>(blocks.change_px.size()) < least_blocks) return none;
  // The first estimate is a constant at the median, so that a large object does not tilt it.
  std::vector<double> medians_px(blocks.change_px.begin(), blocks.change_px.end());
  Drift::Terms coefficients_px = Drift::Terms::Zero();
  coefficients_px[0] = quantile(medians_px, 0.5);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(blocks.change_px.size());
  double deviation = 0.0;
  constexpr int rounds = 15;  // leave less than 1e-7 of an error: equation 87 of docs/math.md
  for (int round = 0; round < rounds; ++round) {
    const Eigen::VectorXd residuals = blocks.change_px - blocks.terms * coefficients_px;
    deviation = deviation_of(residuals);
    if (deviation <= 0.0) break;
    weights = biweights(residuals, deviation);
    const Eigen::VectorXd roots = weights.cwiseSqrt();
    coefficients_px = (roots.asDiagonal() * blocks.terms)
                          .colPivHouseholderQr()
                          .solve(roots.asDiagonal() * blocks.change_px);
  }
  const Eigen::MatrixXd information = blocks.terms.transpose() * weights.asDiagonal() * blocks.terms;
  const Drift::Covariance covariance =
      deviation * deviation * information.completeOrthogonalDecomposition().pseudoInverse();
  return {width, height, coefficients_px, covariance};
}

}  // namespace rva
