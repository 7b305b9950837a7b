// Compares stereo matching with OpenCV's on the same pairs, and space-time stereo with the fused depth
// of the camera.
//
// Frames are from the simulated camera in a wing bay without debris; errors are in pixels of disparity
// against the truth.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <functional>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "core/quantile.hpp"
#include "depth/mat_view.hpp"
#include "geometry/stereo_scale.hpp"
#include "infrared/dot_mask.hpp"
#include "robot/dither.hpp"
#include "scene/file/scene_file.hpp"
#include "sim/sensor/camera_models.hpp"
#include "sim/simulated_camera.hpp"
#include "stereo/space_time.hpp"

namespace {

using namespace rva;

constexpr int rounds = 5;
constexpr int frames = 10;

double least_ms(const std::function<void()>& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < rounds; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    least = std::min(
        least, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  return least;
}

/// The images of one capture.
struct Dither {
  InfraredImage left;  // of the last frame
  InfraredImage right;
  Image<float> camera_px;  // mean of the disparities that the camera computed
  StereoView mean;
};

struct Truth {
  Image<float> disparity_px;
  Image<float> slope_px;  // largest difference of disparity to a neighbour
  cv::Mat from_edge_px;   // distance to the nearest step of disparity
};

Truth truth_of(const SimulatedCamera& camera) {
  constexpr float step_px = 0.7F;
  const Image<float> depth_m = camera.true_view().depth_m;
  Truth truth{{depth_m.width(), depth_m.height()}, {depth_m.width(), depth_m.height()}, {}};
  for (std::size_t i = 0; i < depth_m.size(); ++i)
    truth.disparity_px[i] =
        depth_m[i] > 0.0F ? static_cast<float>(stereo_scale(camera.info()).focal_baseline_m_px) / depth_m[i]
                          : 0.0F;
  cv::Mat edges(depth_m.height(), depth_m.width(), CV_8U, cv::Scalar(255));
  for (int v = 1; v + 1 < depth_m.height(); ++v) {
    for (int u = 1; u + 1 < depth_m.width(); ++u) {
      const Image<float>& d = truth.disparity_px;
      const float steepest = std::max({std::abs(d(u + 1, v) - d(u, v)), std::abs(d(u, v + 1) - d(u, v)),
                                       std::abs(d(u - 1, v) - d(u, v)), std::abs(d(u, v - 1) - d(u, v))});
      truth.slope_px(u, v) = steepest;
      if (steepest > step_px) edges.at<std::uint8_t>(v, u) = 0;
    }
  }
  cv::distanceTransform(edges, truth.from_edge_px, cv::DIST_L2, 5);
  return truth;
}

struct Place {
  const char* name;
  std::function<bool(float slope_px, float from_edge_px)> holds;
};

const std::vector<Place> places{
    {"plane", [](float slope, float edge) { return slope < 0.05F && edge > 8.0F; }},
    {"slope", [](float slope, float edge) { return slope >= 0.1F && slope < 0.3F && edge > 8.0F; }},
    {"1-2 px from an edge", [](float, float edge) { return edge >= 1.0F && edge < 2.0F; }},
    {"2-3 px", [](float, float edge) { return edge >= 2.0F && edge < 3.0F; }},
    {"3-5 px", [](float, float edge) { return edge >= 3.0F && edge < 5.0F; }},
};

/// The errors of all pixels of one class.
struct Errors {
  std::vector<float> sizes_px;  // of the pixels that were matched
  std::size_t all = 0;
};

Errors errors_at(const Place& place, const Image<float>& found_px, const Truth& truth) {
  constexpr int border_px = 20;
  constexpr int left_px = 90;  // columns that the right imager does not see
  Errors errors;
  for (int v = border_px; v < found_px.height() - border_px; ++v) {
    for (int u = left_px; u < found_px.width() - border_px; ++u) {
      const bool there = truth.disparity_px(u, v) > 0.0F;
      if (!there || !place.holds(truth.slope_px(u, v), truth.from_edge_px.at<float>(v, u))) continue;
      ++errors.all;
      if (found_px(u, v) > 0.0F)
        errors.sizes_px.push_back(std::abs(found_px(u, v) - truth.disparity_px(u, v)));
    }
  }
  return errors;
}

void print_errors(const std::string& name, const Image<float>& found_px, const Truth& truth) {
  constexpr float gross_px = 0.5F;
  fmt::print("{:<26}", name);
  for (const Place& place : places) {
    Errors errors = errors_at(place, found_px, truth);
    const auto gross = static_cast<double>(
        std::ranges::count_if(errors.sizes_px, [](float size_px) { return size_px > gross_px; }));
    const auto matched = static_cast<double>(std::max<std::size_t>(errors.sizes_px.size(), 1));
    const auto all = static_cast<double>(std::max<std::size_t>(errors.all, 1));
    fmt::print("  {:.3f} {:4.1f} % {:3.0f} %",
               errors.sizes_px.empty() ? 0.0F : robust_deviation(errors.sizes_px), 100.0 * gross / matched,
               100.0 * matched / all);
  }
  fmt::print("\n");
}

Image<float> disparities(const cv::Mat& found, double scale) {
  Image<float> result(found.cols, found.rows);
  for (int v = 0; v < found.rows; ++v) {
    for (int u = 0; u < found.cols; ++u)
      result(u, v) = std::max(0.0F, static_cast<float>(scale * found.at<std::int16_t>(v, u)));
  }
  return result;
}

Image<float> disparities(const Image<std::uint16_t>& found) {
  constexpr float steps_per_px = 32.0F;
  Image<float> result(found.width(), found.height());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = static_cast<float>(found[i]) / steps_per_px;
  return result;
}

Dither take(SimulatedCamera& camera, const Transform& first_world_from_camera) {
  Dither dither;
  Image<float> sum;
  Image<float> count;
  Image<float> left;
  Image<float> right;
  for (int i = 0; i < frames; ++i) {
    const CameraFrame frame = camera.wait_for_frame().value();
    if (sum.empty()) sum = count = left = right = Image<float>(frame.depth.width(), frame.depth.height());
    const StereoScale stereo = stereo_scale(camera.info());
    for (std::size_t k = 0; k < sum.size(); ++k) {
      left[k] += static_cast<float>(frame.infrared.at(Imager::left)[k]);
      right[k] += static_cast<float>(frame.infrared.at(Imager::right)[k]);
      if (frame.depth[k] == no_depth) continue;
      sum[k] += static_cast<float>(stereo.disparity_px(stereo.unit_m * frame.depth[k]));
      count[k] += 1.0F;
    }
  }
  for (std::size_t k = 0; k < sum.size(); ++k) {
    sum[k] = count[k] > 0.0F ? sum[k] / count[k] : 0.0F;
    left[k] /= static_cast<float>(frames * fine_steps_per_grey_level);
    right[k] /= static_cast<float>(frames * fine_steps_per_grey_level);
  }
  dither.left = camera.left_infrared();
  dither.right = camera.right_infrared();
  dither.camera_px = std::move(sum);
  dither.mean = {log_grey(left), log_grey(right),
                 camera.world_from_camera().inverse() * first_world_from_camera};
  return dither;
}

cv::Mat eight_bits(const InfraredImage& image) {
  cv::Mat result(image.height(), image.width(), CV_8U);
  for (std::size_t i = 0; i < image.size(); ++i) result.data[i] = static_cast<std::uint8_t>(image[i] >> 2U);
  return result;
}

void matchers(const Dither& first, const Truth& truth) {
  constexpr int search_px = 128;
  constexpr double opencv_scale = 1.0 / 16.0;
  fmt::print("one frame (robust deviation in pixels, share over half a pixel, share matched)\n{:<26}", "");
  for (const Place& place : places) fmt::print("  {:<18}", place.name);
  fmt::print("\n");
  for (const char* const model : {"d435", "semi-global", "correlation-9"}) {
    const StereoSensorOptions options = camera_model(model);
    print_errors(model, disparities(match_stereo(first.left, first.right, options)), truth);
  }
  const cv::Mat left = eight_bits(first.left);
  const cv::Mat right = eight_bits(first.right);
  const auto bm = cv::StereoBM::create(search_px, 9);
  const auto sgbm = cv::StereoSGBM::create(0, search_px, 5, 8 * 25, 32 * 25, 1, 63, 10, 100, 2);
  cv::Mat found;
  bm->compute(left, right, found);
  print_errors("OpenCV StereoBM", disparities(found, opencv_scale), truth);
  sgbm->compute(left, right, found);
  print_errors("OpenCV StereoSGBM", disparities(found, opencv_scale), truth);
  const double bm_ms = least_ms([&] { bm->compute(left, right, found); });
  const double sgbm_ms = least_ms([&] { sgbm->compute(left, right, found); });
  for (const char* const model : {"d435", "semi-global", "correlation-9"}) {
    const StereoSensorOptions options = camera_model(model);
    const double ours_ms = least_ms([&] { (void)match_stereo(first.left, first.right, options); });
    fmt::print("{:<14} takes {:5.1f} ms: {:.2f} of StereoBM's time, {:.2f} of StereoSGBM's\n", model, ours_ms,
               ours_ms / bm_ms, ours_ms / sgbm_ms);
  }
}

/// The mean of the camera's disparities over several captures, transformed into the view of the first.
class CameraMean {
 public:
  CameraMean(const ReferenceSurface& start, const StereoScale& stereo)
      : start_(start),
        stereo_(stereo),
        sum_(start.camera.width, start.camera.height),
        count_(start.camera.width, start.camera.height) {}

  void add(const Dither& dither) {
    const ViewOfSurface where(start_, dither.mean.view_from_reference);
    for (int v = 0; v < sum_.height(); ++v) {
      for (int u = 0; u < sum_.width(); ++u) {
        const float seen_px = seen_in(dither, where.seen_at(u, v));
        sum_(u, v) += seen_px;
        if (seen_px > 0.0F) count_(u, v) += 1.0F;
      }
    }
  }

  [[nodiscard]] Image<float> mean() const {
    Image<float> mean = sum_;
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] /= std::max(count_[i], 1.0F);
    return mean;
  }

 private:
  // The disparity in the first view of a point that another capture measured; 0 if it measured none.
  [[nodiscard]] float seen_in(const Dither& dither, const Eigen::Vector2f& at) const {
    const auto column = static_cast<int>(std::lround(at.x()));
    const auto row = static_cast<int>(std::lround(at.y()));
    if (column < 0 || row < 0 || column >= sum_.width() || row >= sum_.height()) return 0.0F;
    const float there_px = dither.camera_px(column, row);
    if (there_px <= 0.0F) return 0.0F;
    const Eigen::Vector3d point =
        dither.mean.view_from_reference.inverse() *
        start_.camera.deproject({static_cast<double>(column), static_cast<double>(row)},
                                stereo_.depth_m(static_cast<double>(there_px)));
    return static_cast<float>(stereo_.disparity_px(point.z()));
  }

  const ReferenceSurface& start_;
  StereoScale stereo_;
  Image<float> sum_;
  Image<float> count_;
};

void space_time(const std::vector<Dither>& side, const Truth& truth, const Intrinsics& camera,
                const StereoScale& stereo) {
  fmt::print("\nmeans of {} frames, poses known\n", frames);
  const ReferenceSurface start = reference_surface(camera, side.front().camera_px, stereo);
  for (const std::size_t captures : {std::size_t{1}, std::size_t{4}, std::size_t{8}}) {
    std::vector<StereoView> views;
    CameraMean mean(start, stereo);
    for (std::size_t k = 0; k < captures; ++k) {
      views.push_back(side[k].mean);
      mean.add(side[k]);
    }
    print_errors(fmt::format("{} captures: camera's", captures), mean.mean(), truth);
    print_errors(fmt::format("{} captures: space-time", captures), space_time_disparity(start, stereo, views),
                 truth);
    fmt::print("{:<26}  {:.0f} ms\n", "",
               least_ms([&] { (void)space_time_disparity(start, stereo, views); }));
  }
}

void measure(const std::string& scene_file) {
  const Scene scene = load_scene(scene_file, {.no_debris = true});
  const PanTilt stand{scene.stand.pan_deg, scene.stand.tilt_deg};
  PanTilt joints = stand;
  SimulatedCamera camera(scene, {}, 1, ColorFrames::none, [&joints] { return joints; });
  const Truth truth = truth_of(camera);
  const Transform first = camera.world_from_camera();
  std::vector<Dither> side;
  for (const PanTilt& offset : dither_offsets(8)) {
    joints = {stand.pan_deg + offset.pan_deg, stand.tilt_deg + offset.tilt_deg};
    side.push_back(take(camera, first));
  }
  matchers(side.front(), truth);
  space_time(side, truth, camera.info().depth, stereo_scale(camera.info()));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: {} SCENE\n", argv[0]);
    return 2;
  }
  try {
    measure(argv[1]);
  } catch (const std::exception& failure) {
    fmt::print(stderr, "{}\n", failure.what());
    return 1;
  }
}
