// The formats that open_capture() reads, with one function each, and their parsers.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "capture/capture.hpp"
#include "capture/no_depth.hpp"

namespace rva {

/// The files of a FolderCapture, by name.
struct FrameFiles {
  std::vector<std::filesystem::path> depth;  ///< in the order of the frames
  std::vector<std::filesystem::path> color;  ///< in any order; see `color_of`
  /// One for each frame, or a single one that is the mean of all frames.
  std::map<std::pair<Imager, Light>, std::vector<std::filesystem::path>> infrared{};
  std::map<std::size_t, FrameMetadata> metadata{};  ///< by the frame number that is a depth file's name
  /// For each depth file, the index in `color` of the image that was taken with it. Empty when images are to
  /// be paired by the names of their files.
  std::vector<std::optional<std::size_t>> color_of{};
};

/// A capture whose frames are image files. Depth and other images are paired if their files have the same
/// name; where no two do, if their names end in the same number: depth_007 and color_7.
class FolderCapture : public Capture {
 public:
  /// @param source the capture's path, for errors
  /// @throws Error when there is no depth file, or the description is impossible (require_possible())
  FolderCapture(const std::filesystem::path& source, CaptureInfo info, FrameFiles files);

  [[nodiscard]] std::size_t depth_frames() const override { return files_.depth.size(); }
  [[nodiscard]] std::size_t color_frames() const override { return files_.color.size(); }
  [[nodiscard]] DepthImage depth(std::size_t i) const override;
  [[nodiscard]] std::vector<std::string> depth_notes() const override;
  [[nodiscard]] bool marks_no_depth_by_zero() const override;
  [[nodiscard]] ColorImage color(std::size_t i) const override;
  [[nodiscard]] std::optional<ColorImage> color_of(std::size_t depth_frame) const override;
  [[nodiscard]] std::optional<FineGrayImage> infrared_of(std::size_t depth_frame,
                                                         Imager imager) const override;
  [[nodiscard]] bool has_infrared(Imager imager, Light light) const override;
  [[nodiscard]] std::optional<Image<float>> infrared_mean(Imager imager, Light light) const override;
  [[nodiscard]] FrameMetadata metadata_of(std::size_t depth_frame) const override;

 private:
  [[nodiscard]] DepthImage stored_depth(std::size_t i) const;
  [[nodiscard]] Image<float> read_infrared_of(const std::filesystem::path& file, Light light) const;

  FrameFiles files_;
  NoDepthValues no_depth_;
  std::vector<std::optional<std::size_t>> color_of_;                         // by depth frame
  std::map<Imager, std::vector<std::optional<std::size_t>>> infrared_of_{};  // the same, for infrared
};

/// capture.json, depth/*.png, color/*.png|jpg: our own format (docs/captures.md).
[[nodiscard]] std::unique_ptr<Capture> open_capture_folder(const std::filesystem::path& folder,
                                                           const CaptureOptions& options);

/// Open3D's recorders: intrinsic.json or camera_intrinsic.json, depth/*.png, color/*.jpg|png. Their depth is
/// aligned to colour, so that both share one view.
[[nodiscard]] std::unique_ptr<Capture> open_open3d_folder(const std::filesystem::path& folder,
                                                          const std::filesystem::path& intrinsic_file,
                                                          const CaptureOptions& options);

/// The TUM RGB-D benchmark's format: depth.txt, rgb.txt and the images that they list, or an association list
/// (associations.txt), with 5000 units per metre where the options state no other unit.
/// @throws Error also when the options state no intrinsics
[[nodiscard]] std::unique_ptr<Capture> open_tum_folder(const std::filesystem::path& folder,
                                                       const CaptureOptions& options);

/// The depth images of a folder without a description: depth/*, or else *, in the formats of
/// read_depth_file(). Empty where there are none.
/// @throws Error when a folder cannot be read
[[nodiscard]] std::vector<std::filesystem::path> bare_depth_files(const std::filesystem::path& folder);

/// A folder with bare_depth_files(). The options state the intrinsics and the unit (1 mm where they
/// state none).
/// @throws Error when the options state no intrinsics
[[nodiscard]] std::unique_ptr<Capture> open_bare_folder(const std::filesystem::path& folder,
                                                        const CaptureOptions& options);

/// A recording of realsense-viewer, librealsense's recorder or ROS: a ROS bag of version 2.0 with chunks that
/// are compressed by LZ4 or uncompressed, a rosbag2 database (.db3, librealsense from 2.58 on) with messages
/// that are compressed by Zstandard or uncompressed, or an MCAP file. The file may have any size, since
/// frames are read on request. If the recorder was interrupted, the complete frames are available, and
/// info().notes states this.
[[nodiscard]] std::unique_ptr<Capture> open_recording(const std::filesystem::path& file,
                                                      const CaptureOptions& options);

/// The subfolder of a capture for an imager's images under a light: "infrared", "lamp/infrared_right", ...
[[nodiscard]] std::filesystem::path infrared_folder(Imager imager, Light light);

/// Parses the text of a capture.json; separate from open_capture_folder() so that tests can pass any text.
/// @param source the file's name, for errors, here and below
/// @throws Error naming the line or the field that is wrong
[[nodiscard]] CaptureInfo parse_capture_json(const std::string& text, const std::string& source);

/// Refuses a description whose values are valid one by one but impossible for a capture: image sizes, focal
/// lengths and principal point of depth, the depth unit, the baseline.
/// @throws Error
void require_possible(const CaptureInfo& info, const std::string& source);

/// Applies the depth unit of the options, if any. Adds a note where it differs from what the files state, and
/// where neither states a unit.
/// @param info with the unit that the files state, or else the usual one of their format
void settle_unit(const CaptureOptions& options, CaptureInfo& info);

/// Parses the text of an Open3D intrinsic file. @throws Error as parse_capture_json()
[[nodiscard]] CaptureInfo parse_open3d_json(const std::string& text, const std::string& source);

/// One line of frames.jsonl, with its line end. Unknown values are left out.
[[nodiscard]] std::string frame_line(std::size_t number, const FrameMetadata& metadata);

/// Parses the text of frames.jsonl. A last line without a line end is left out: it was being written when the
/// recorder was interrupted.
/// @return metadata by frame number
/// @throws Error naming a malformed line
[[nodiscard]] std::map<std::size_t, FrameMetadata> parse_frame_lines(const std::string& text,
                                                                     const std::string& source);

/// One line of a TUM list: a time and a file name.
struct TumEntry {
  double time_s = 0.0;  ///< seconds, by the recorder's clock
  std::string file;     ///< path of the image, relative to the folder of the list
};

/// A depth image and the colour image that belongs to it.
struct TumPair {
  TumEntry depth;  ///< of the depth image
  TumEntry color;  ///< of the colour image
};

/// Parses the text of an association list, as the benchmark's tool and SLAM programs use it: in each line
/// time and file of two images, without spaces. Depth is the one with `depth` in its name in the first line,
/// or else the second one, as the tool writes it.
/// @throws Error naming a line that is not `seconds file seconds file`
[[nodiscard]] std::vector<TumPair> parse_associations(const std::string& text, const std::string& source);

/// The association list of a folder; empty where there is none.
[[nodiscard]] std::optional<std::filesystem::path> association_list(const std::filesystem::path& folder);

/// Parses the text of a TUM list. @throws Error naming a line that is not `seconds file`
[[nodiscard]] std::vector<TumEntry> parse_tum_list(const std::string& text, const std::string& source);

/// The files of `folder` whose names end in one of `endings` (given in lower case; file names may have
/// either), without hidden files, in the order of their names, in which numbers are compared by value: 2.png
/// before 10.png. Empty when there is no such folder.
/// @throws Error when the folder cannot be read
[[nodiscard]] std::vector<std::filesystem::path> image_files(const std::filesystem::path& folder,
                                                             const std::vector<std::string_view>& endings);

}  // namespace rva
