// A capture: what one camera saw from one place, as files hold it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "depth/image.hpp"
#include "geometry/intrinsics.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// Where the camera stood. Captures whose `base` agree share one world frame.
struct Pose {
  std::optional<std::string> base;
  std::optional<double> pan_deg;
  std::optional<double> tilt_deg;
  std::optional<Transform> world_from_camera;
  /// Of a capture after the work whose pose was approached more than once: how far the images show it from
  /// the baseline's, and how many approaches were made.
  std::optional<double> off_baseline_deg{};
  std::optional<int> approaches{};
};

/// Which camera it was, and how it was set. Texts are empty where unknown.
struct CameraInfo {
  std::string model;
  std::string serial;
  std::optional<double> baseline_m{};  ///< distance between the two imagers of a stereo camera
  std::string firmware{};
  std::string usb{};  ///< the port that it was at: "3.2"
  /// By imager, then by the maker's names and in his units: "Stereo Module", "Laser Power", 150.
  std::map<std::string, std::map<std::string, double>> settings{};
};

/// The infrared imagers of a stereo camera. The left one's pixels are those of the depth images; the right
/// one is rectified with it.
enum class Imager { left, right };
inline constexpr std::array<Imager, 2> both_imagers{Imager::left, Imager::right};

/// What lights the infrared images: the projector, whose dots depth is made from, or a lamp while the
/// projector is off.
enum class Light { projector, lamp };

/// How infrared images count, of single frames or of the mean of several (16 bits), and how they were
/// exposed.
struct InfraredBurst {
  double per_grey_level = 1.0;  ///< counts of 16 bits for one level of 8 bits
  int frames = 1;               ///< that an image is the mean of
  std::optional<double> exposure_us{};
  std::optional<double> gain{};
  std::optional<double> laser_power_mw{};  ///< 0: the projector was off
  bool operator==(const InfraredBurst&) const = default;
};

/// What is known of a capture besides its images.
struct CaptureInfo {
  std::string format;  ///< "rva-capture", "open3d", "tum", "images", "bag", "db3", "mcap"
  Intrinsics depth;
  double depth_unit_m = 0.001;   ///< metres of one step of a depth image
  bool unit_is_assumed = false;  ///< the files do not state it
  std::optional<Intrinsics> color;
  std::optional<Transform> color_from_depth;
  std::optional<Pose> pose;
  std::optional<CameraInfo> camera;
  std::optional<InfraredBurst> infrared{};  ///< of images under the projector
  std::optional<InfraredBurst> lamp{};      ///< of images under the lamp
  std::string captured_at;                  ///< ISO 8601, empty where unknown
  std::string source_json;  ///< the description as it was read, keys that we do not know included
  std::vector<std::uint16_t> no_depth{};  ///< values of depth that mean no measurement, besides 0 and 65535
  std::vector<std::string> notes{};  ///< what a person should know of the files; sentences without full stop
};

/// What a camera says of one frame; empty where it does not.
struct FrameMetadata {
  std::optional<std::uint64_t> counter;  ///< the camera's own, up by one a frame: a gap is lost frames
  std::optional<double> time_s;          ///< when depth was exposed, by the camera's clock: for differences
  std::optional<double> exposure_us;
  std::optional<double> gain;
  std::optional<double> laser_power_mw;
  std::optional<double> temperature_c;  ///< of the chip that computes depth

  bool operator==(const FrameMetadata&) const = default;
};

/// Frames and their description, whoever recorded them. Reading is const and may run on several threads.
class Capture {
 public:
  explicit Capture(CaptureInfo info) : info_(std::move(info)) {}
  virtual ~Capture() = default;
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;

  [[nodiscard]] const CaptureInfo& info() const { return info_; }
  [[nodiscard]] virtual std::size_t depth_frames() const = 0;
  [[nodiscard]] virtual std::size_t color_frames() const = 0;

  /// @param i frame, from 0, below depth_frames()
  /// @return  an image of the size that info().depth states; values that mean no measurement are no_depth
  ///          (no_depth.hpp)
  /// @throws  Error when the frame is damaged or of another size
  [[nodiscard]] virtual DepthImage depth(std::size_t i) const = 0;

  /// What a person should know of the depth images; sentences without a full stop. Reads the first one.
  /// @throws Error as depth()
  [[nodiscard]] virtual std::vector<std::string> depth_notes() const { return {}; }

  /// False where other values stand for no measurement throughout: some tool wrote them, and may have cut off
  /// depth that the camera did measure. Reads the first depth image.
  [[nodiscard]] virtual bool marks_no_depth_by_zero() const { return true; }

  /// As depth(); the image has the size that info().color states, if it states one.
  [[nodiscard]] virtual ColorImage color(std::size_t i) const = 0;

  /// The colour image that was taken with a depth frame; empty where there is none. Images that were taken
  /// with no depth frame are of none.
  /// @param depth_frame below depth_frames(), here and below
  [[nodiscard]] virtual std::optional<ColorImage> color_of(std::size_t depth_frame) const;

  /// An imager's infrared image of a depth frame under the projector, of the size of the depth images; empty
  /// where there is none. An image that is the mean of all frames is that of each.
  [[nodiscard]] virtual std::optional<FineGrayImage> infrared_of(std::size_t depth_frame,
                                                                 Imager imager) const;

  /// True when there are infrared images of this imager in this light.
  [[nodiscard]] virtual bool has_infrared(Imager imager, Light light) const;

  /// The mean of an imager's infrared images in a light, in levels of 8 bits with fractions; empty where
  /// there is none. @throws Error as depth()
  [[nodiscard]] virtual std::optional<Image<float>> infrared_mean(Imager imager, Light light) const;

  [[nodiscard]] virtual FrameMetadata metadata_of(std::size_t depth_frame) const;

 private:
  CaptureInfo info_;
};

/// Of one view, or of one side of an inspection.
using Captures = std::vector<std::unique_ptr<Capture>>;

/// What a capture's own files may leave out.
struct CaptureOptions {
  /// Intrinsics for a format that carries none (TUM); the size is that of the first image.
  std::optional<Intrinsics> intrinsics;
  /// Values of depth that mean no measurement, besides those that the capture states.
  std::vector<std::uint16_t> no_depth{};
  /// Metres of one step of the depth images, whatever the capture states.
  std::optional<double> depth_unit_m{};
  /// The topic of the depth images of a recording of ROS, instead of the one that would be chosen.
  std::optional<std::string> topic{};
};

/// The infrared images that a depth frame has. @throws Error as Capture::depth()
[[nodiscard]] std::map<Imager, FineGrayImage> infrared_of(const Capture& capture, std::size_t depth_frame);

/// Frames that the camera lost between those of the capture, by its counter; 0 where it tells none.
/// @throws Error
[[nodiscard]] std::size_t lost_frames(const Capture& capture);

/// Opens a capture folder, an Open3D recorder folder, a TUM RGB-D folder or a folder of bare depth images,
/// told apart by the files in it, or a .bag, .db3 or .mcap, or a folder that holds one. Images
/// are not read yet, but the first one where nothing else states their size.
/// @throws Error when it is none of these, its description is missing or malformed, or it has no depth frame
[[nodiscard]] std::unique_ptr<Capture> open_capture(const std::filesystem::path& path,
                                                    const CaptureOptions& options = {});

}  // namespace rva
