// Registers two captures that a camera took from different positions, and prints the transform and its
// one-sigma uncertainty, or the reason for not trusting it. Run it as `build/examples/register_views INITIAL
// FINAL` with captures that the example `simulate` wrote (README.md).
#include <fmt/format.h>

#include <Eigen/Core>
#include <numbers>

#include "capture/capture.hpp"
#include "core/error.hpp"
#include "views/depth_view.hpp"
#include "views/registration.hpp"

namespace {

void print(const rva::Registration& registration) {
  const Eigen::Matrix4d& matrix = registration.initial_from_final.matrix();
  fmt::print("initial_from_final (translation in metres)\n");
  for (int row = 0; row < 3; ++row)
    fmt::print("  {:9.6f} {:9.6f} {:9.6f} {:9.6f}\n", matrix(row, 0), matrix(row, 1), matrix(row, 2),
               matrix(row, 3));
  // The covariance is that of a small motion in the initial camera's frame, applied after the transform.
  const Eigen::Matrix<double, 6, 1> sigma = registration.covariance.diagonal().cwiseSqrt();
  const double deg = 180.0 / std::numbers::pi;
  fmt::print("one sigma, rotation about x y z     {:.4f} {:.4f} {:.4f} deg\n", deg * sigma[0], deg * sigma[1],
             deg * sigma[2]);
  fmt::print("one sigma, translation along x y z  {:.3f} {:.3f} {:.3f} mm\n", 1000.0 * sigma[3],
             1000.0 * sigma[4], 1000.0 * sigma[5]);
  fmt::print("overlap {:.1f} %\n", 100.0 * registration.overlap);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: register_views INITIAL FINAL\n");
    return 2;
  }
  try {
    const rva::Registration registration = rva::register_views(rva::depth_view(*rva::open_capture(argv[1])),
                                                               rva::depth_view(*rva::open_capture(argv[2])));
    if (registration.trusted()) {
      print(registration);
      return 0;
    }
    fmt::print(stderr, "register_views: refused: {}\n", registration.doubt);
    return 1;
  } catch (const rva::Error& error) {
    fmt::print(stderr, "register_views: {}\n", error.what());
    return 1;
  }
}
