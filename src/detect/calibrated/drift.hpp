// What changed everywhere: a camera that grew warmer sees every depth a little otherwise.
#pragma once

#include <Eigen/Core>

#include "detect/calibrated/disparity_change.hpp"

namespace rva {

/// A change of disparity that is smooth over the image: a polynomial of second degree in u and v.
class Drift {
 public:
  static constexpr int terms = 6;
  using Terms = Eigen::Matrix<double, terms, 1>;
  using Covariance = Eigen::Matrix<double, terms, terms>;

  Drift(int width, int height, const Terms& coefficients_px, const Covariance& covariance_px2);

  /// At every pixel.
  [[nodiscard]] Image<float> px() const;
  /// How uncertain that is: variance, square pixels.
  [[nodiscard]] Image<float> variance_px2() const;

  /// The polynomial's terms 1, x, y, x^2, xy, y^2 at a place, which may lie between pixels.
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

/// Through the medians of blocks of 32 x 32 pixels, with Tukey's biweight (Beaton and Tukey 1974), so that
/// neither debris within a block nor a rag over several has a say while less than half of the image changed.
/// None, without uncertainty, where fewer than twelve blocks were judged.
[[nodiscard]] Drift fit_drift(const DisparityChange& change);

}  // namespace rva
