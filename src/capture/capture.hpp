// A capture: what one camera recorded from one position, and its description.
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
#include "geometry/stereo_scale.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// The camera's pose. Captures with the same `base` share one world frame.
struct Pose {
  std::optional<std::string> base;  ///< name of the position of the robot's foot; empty if there was no robot
  std::optional<double> pan_deg;    ///< reported by the robot at rest; positive is left
  std::optional<double> tilt_deg;   ///< reported by the robot at rest; positive is up
  std::optional<Transform> world_from_camera;  ///< pose of the depth imager
  /// How far the images show the camera from the pose of the baseline's capture, and how many approaches were
  /// made. Empty unless the pose of a baseline was approached again.
  std::optional<double> off_baseline_deg{};
  std::optional<int> approaches{};  ///< number of approaches made
};

/// Which camera it was, and how it was set. Texts are empty where unknown.
struct CameraInfo {
  std::string model;                   ///< name of the product
  std::string serial;                  ///< serial number
  std::optional<double> baseline_m{};  ///< distance between the two imagers of a stereo camera
  std::string firmware{};              ///< version of the firmware
  std::string usb{};                   ///< type of the port that it was connected to: "3.2"
  /// By sensor, then by the manufacturer's name, in the manufacturer's unit: "Stereo Module", "Laser
  /// Power", 150.
  std::map<std::string, std::map<std::string, double>> settings{};
};

/// The infrared imagers of a stereo camera. The left imager has the pixel grid of the depth images; the right
/// one is rectified with it.
enum class Imager { left, right };

/// Both imagers, left first.
inline constexpr std::array<Imager, 2> both_imagers{Imager::left, Imager::right};

/// What illuminates the infrared images: the projector, whose dots the stereo matcher uses, or a lamp while
/// the projector is off.
enum class Light { projector, lamp };

/// Scale and exposure of infrared images, which are single frames or the mean of several (16 bits).
struct InfraredBurst {
  double per_grey_level = 1.0;             ///< counts of a 16-bit image per grey level of an 8-bit image
  int frames = 1;                          ///< number of frames that an image is the mean of
  std::optional<double> exposure_us{};     ///< exposure time, microseconds
  std::optional<double> gain{};            ///< in the manufacturer's unit
  std::optional<double> laser_power_mw{};  ///< 0: the projector was off
  bool operator==(const InfraredBurst&) const = default;
};

/// What is known of a capture besides its images.
struct CaptureInfo {
  std::string format;               ///< "rva-capture", "open3d", "tum", "images", "bag", "db3", "mcap"
  Intrinsics depth;                 ///< of the depth images
  double depth_unit_m = 0.001;      ///< depth of one step of a depth image, metres
  bool unit_is_assumed = false;     ///< true when the files do not state the unit
  std::optional<Intrinsics> color;  ///< of the colour images, where their description states them
  /// From the depth imager to the colour imager, where it is known.
  std::optional<Transform> color_from_depth;
  std::optional<Pose> pose;                 ///< of the depth imager; empty where it is not known
  std::optional<CameraInfo> camera;         ///< empty where nothing is known of it
  std::optional<InfraredBurst> infrared{};  ///< of the images under the projector
  std::optional<InfraredBurst> lamp{};      ///< of the images under the lamp
  std::string captured_at;                  ///< ISO 8601, empty where unknown
  std::string source_json;                  ///< the description as it was read, including unknown keys
  std::vector<std::uint16_t> no_depth{};    ///< depth values that mean no measurement, besides 0 and 65535
  std::vector<std::string> notes{};  ///< remarks on the files for the user; sentences without a full stop
};

/// What a camera states about one frame; empty where it states nothing.
struct FrameMetadata {
  std::optional<std::uint64_t> counter;  ///< the camera's own, up by one per frame: a gap means lost frames
  std::optional<double> time_s;          ///< when depth was exposed, by the camera's clock; for differences
  std::optional<double> exposure_us;     ///< exposure time of the infrared imagers, microseconds
  std::optional<double> gain;            ///< in the manufacturer's unit
  std::optional<double> laser_power_mw;  ///< of the projector; 0: it was off
  std::optional<double> temperature_c;   ///< of the chip that computes depth

  bool operator==(const FrameMetadata&) const = default;
};

/// Frames and their description, from any recorder. Reading is const and may run on several threads.
class Capture {
 public:
  /// @param info the description, returned by info()
  explicit Capture(CaptureInfo info) : info_(std::move(info)) {}
  virtual ~Capture() = default;
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;

  /// The description of the capture, which does not change.
  [[nodiscard]] const CaptureInfo& info() const { return info_; }
  /// Number of depth images.
  [[nodiscard]] virtual std::size_t depth_frames() const = 0;
  /// Number of colour images, which may differ from that of depth images.
  [[nodiscard]] virtual std::size_t color_frames() const = 0;

  /// Reads one depth image.
  /// @param i frame, from 0, below depth_frames()
  /// @return  an image of the size that info().depth states, in units of info().depth_unit_m; values that
  ///          mean no measurement are no_depth (no_depth.hpp)
  /// @throws  Error when the frame is damaged or of another size
  [[nodiscard]] virtual DepthImage depth(std::size_t i) const = 0;

  /// Remarks on the depth images for the user; sentences without a full stop. Reads the first depth image.
  /// @throws Error as depth()
  [[nodiscard]] virtual std::vector<std::string> depth_notes() const { return {}; }

  /// False when the first depth image has other values that mean no measurement and no 0: some tool wrote
  /// them, and may have clipped depth that the camera did measure. Reads the first depth image.
  [[nodiscard]] virtual bool marks_no_depth_by_zero() const { return true; }

  /// The colour image `i`, below color_frames(), of the size that info().color states, if any.
  /// @throws Error as depth()
  [[nodiscard]] virtual ColorImage color(std::size_t i) const = 0;

  /// The colour image that was taken with a depth frame; empty where there is none. Not every colour image
  /// needs to belong to a depth frame.
  /// @param depth_frame below depth_frames(), here and below
  [[nodiscard]] virtual std::optional<ColorImage> color_of(std::size_t depth_frame) const;

  /// An imager's infrared image of a depth frame under the projector, of the size of the depth images; empty
  /// where there is none. An image that is the mean of all frames is returned for each frame.
  [[nodiscard]] virtual std::optional<FineGrayImage> infrared_of(std::size_t depth_frame,
                                                                 Imager imager) const;

  /// Whether there are infrared images of this imager under this light.
  [[nodiscard]] virtual bool has_infrared(Imager imager, Light light) const;

  /// The mean of an imager's infrared images under a light, in grey levels (0 to 255, with fractions); empty
  /// where there is none. @throws Error as depth()
  [[nodiscard]] virtual std::optional<Image<float>> infrared_mean(Imager imager, Light light) const;

  /// What the camera stated about a depth frame; empty values where it stated nothing.
  [[nodiscard]] virtual FrameMetadata metadata_of(std::size_t depth_frame) const;

 private:
  CaptureInfo info_;
};

/// The captures of one view, or of one side of an inspection.
using Captures = std::vector<std::unique_ptr<Capture>>;

/// What the user states about a capture, in addition to its files or in place of them.
struct CaptureOptions {
  /// Intrinsics of the depth images where the files state none; the size is that of the first image.
  std::optional<Intrinsics> intrinsics;
  /// Depth values that mean no measurement, besides those that the capture states.
  std::vector<std::uint16_t> no_depth{};
  /// Depth of one step of the depth images, metres; overrides what the capture states.
  std::optional<double> depth_unit_m{};
  /// The topic of the depth images of a ROS recording, instead of the one chosen automatically.
  std::optional<std::string> topic{};
};

/// The infrared images of a depth frame, by imager. @throws Error as Capture::depth()
[[nodiscard]] std::map<Imager, FineGrayImage> infrared_of(const Capture& capture, std::size_t depth_frame);

/// Number of frames that the camera lost between those of the capture, by its counter; 0 where there is no
/// counter. @throws Error as Capture::metadata_of()
[[nodiscard]] std::size_t lost_frames(const Capture& capture);

/// Opens a capture folder, an Open3D recorder folder, a TUM RGB-D folder or a folder of bare depth images,
/// which are distinguished by the files in it, or a .bag, .db3 or .mcap file, or a folder that contains one.
/// Images are not read yet, except the first one where nothing else states their size.
/// @throws Error when it is none of these, its description is missing or malformed, or it has no depth frame
[[nodiscard]] std::unique_ptr<Capture> open_capture(const std::filesystem::path& path,
                                                    const CaptureOptions& options = {});

/// The scale between a capture's depth and disparity. If the capture does not state its stereo baseline, 50
/// mm is assumed, and disparities are not in true pixels.
[[nodiscard]] StereoScale stereo_scale(const CaptureInfo& info);

}  // namespace rva
