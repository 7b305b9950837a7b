// Drift: a smooth change of all disparities, as a camera that grows warmer causes it.
#pragma once

#include <Eigen/Core>

#include "views/disparity_change.hpp"

namespace rva {

/// A change of disparity that is smooth over the image: a polynomial of second degree in u and v.
class Drift {
 public:
  static constexpr int terms = 6;  ///< number of terms of the polynomial
  /// Coefficients of the terms 1, x, y, x^2, xy, y^2.
  using Terms = Eigen::Matrix<double, terms, 1>;
  /// Covariance of the coefficients, in the order of the terms.
  using Covariance = Eigen::Matrix<double, terms, terms>;

  /// @param width, height size of the image, px
  Drift(int width, int height, const Terms& coefficients_px, const Covariance& covariance_px2);

  /// The drift at every pixel.
  [[nodiscard]] Image<float> px() const;
  /// Variance of the drift at every pixel, square pixels.
  [[nodiscard]] Image<float> variance_px2() const;

  /// The terms 1, x, y, x^2, xy, y^2 of the polynomial at a point of the image, which may lie between pixels.
  /// x and y are measured from the centre, in halves of the longer side.
  [[nodiscard]] Terms terms_at(double u, double v) const;

 private:
  struct RowTerms {
    Terms a;
    Terms b;
    Terms c;
  };
  [[nodiscard]] double x_of(double u) const;
  [[nodiscard]] RowTerms row_terms(double v) const;

  int width_;
  int height_;
  double center_u_;
  double center_v_;
  double scale_;
  Terms coefficients_px_;
  Covariance covariance_px2_;
};

/// Fits the drift to the medians of blocks of 32 x 32 pixels with Tukey's biweight (Beaton and Tukey
/// 1974), so that neither debris within a block nor an object over several blocks biases it, as long as
/// less than half of the image changed. Returns a drift of 0 without uncertainty if fewer than twelve
/// blocks were judged.
[[nodiscard]] Drift fit_drift(const DisparityChange& change);

}  // namespace rva
