// The folders that open_capture() understands, one function each.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "depth/capture.hpp"
#include "depth/no_depth.hpp"

namespace rva {

/// The files of a FolderCapture, by name.
struct FrameFiles {
  std::vector<std::filesystem::path> depth;
  std::vector<std::filesystem::path> color;
  std::map<std::pair<Imager, Light>, std::vector<std::filesystem::path>> infrared{};
  std::map<std::size_t, FrameMetadata> metadata{};  ///< by the number that a depth file is called by
  /// For each depth file, the position in `color` of the image that was taken with it. Empty where the files'
  /// names show which go together.
  std::vector<std::optional<std::size_t>> color_of{};
};

/// A capture whose frames are image files. Files of one name go together; where no two have the same name,
/// those whose names end in the same number do: depth_007 and color_7.
class FolderCapture : public Capture {
 public:
  /// @param place where the capture is, for errors
  /// @throws Error when there is no depth file, or the description is unsound (sizes, intrinsics, unit)
  FolderCapture(const std::filesystem::path& place, CaptureInfo info, FrameFiles files);

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
  std::map<Imager, std::vector<std::optional<std::size_t>>> infrared_of_{};  // the same, under the projector
};

/// capture.json, depth/*.png, color/*.png|jpg: our own format (docs/captures.md).
[[nodiscard]] std::unique_ptr<Capture> open_capture_folder(const std::filesystem::path& folder,
                                                           const CaptureOptions& options);

/// intrinsic.json or camera_intrinsic.json, depth/*.png, color/*.jpg|png: what Open3D's recorders write.
/// Depth is aligned to colour there, so both share one view.
[[nodiscard]] std::unique_ptr<Capture> open_open3d_folder(const std::filesystem::path& folder,
                                                          const std::filesystem::path& intrinsic_file,
                                                          const CaptureOptions& options);

/// depth.txt, rgb.txt and the images they list: the TUM RGB-D benchmark's format, 5000 units a metre where
/// the options state no other unit.
[[nodiscard]] std::unique_ptr<Capture> open_tum_folder(const std::filesystem::path& folder,
                                                       const CaptureOptions& options);

/// The depth images of a folder that nothing describes: depth/*, or else *, of the kinds that
/// read_depth_file() reads. Empty where there are none.
/// @throws Error when a folder cannot be read
[[nodiscard]] std::vector<std::filesystem::path> bare_depth_files(const std::filesystem::path& folder);

/// A folder with bare_depth_files(), of the intrinsics and the unit that the options state (1 mm where they
/// state none).
/// @throws Error when the options state no intrinsics
[[nodiscard]] std::unique_ptr<Capture> open_bare_folder(const std::filesystem::path& folder,
                                                        const CaptureOptions& options);

/// A file as realsense-viewer and librealsense's recorder write it: a ROS bag of version 2.0, with chunks
/// packed by LZ4 or not at all, or, from librealsense 2.58 on, a database of rosbag2 (.db3), with messages
/// packed by Zstandard or not at all. A file of any size: frames are read when they are asked for. One whose
/// recorder was stopped gives the frames that are whole, and says so in info().notes.
[[nodiscard]] std::unique_ptr<Capture> open_recording(const std::filesystem::path& file,
                                                      const CaptureOptions& options);

/// Where a capture folder has the images of an imager in a light: "infrared", "lamp/infrared_right", ...
[[nodiscard]] std::filesystem::path infrared_folder(Imager imager, Light light);

/// The description of a capture folder from its text; apart from open_capture_folder() so that it can be
/// tried with any text.
/// @throws Error naming the line or the field, `place` in front
[[nodiscard]] CaptureInfo parse_capture_json(const std::string& text, const std::string& place);

/// Refuses what every field allows by itself and no capture can have: sizes, the unit, the baseline.
/// @param place what to call it in an error
/// @throws Error
void require_possible(const CaptureInfo& info, const std::string& place);

/// Takes the depth unit that the options state, if they do. Notes where that is another than the files state,
/// and where the files state none.
/// @param info with the files' own unit, or the usual one of their format
void settle_unit(const CaptureOptions& options, CaptureInfo& info);

/// As parse_capture_json(), of an Open3D intrinsic file.
[[nodiscard]] CaptureInfo parse_open3d_json(const std::string& text, const std::string& place);

/// One line of frames.jsonl. What is not known is left out.
[[nodiscard]] std::string frame_line(std::size_t number, const FrameMetadata& metadata);

/// By the frame's number, from the text of frames.jsonl. A last line without an end is left out: it was being
/// written when the recorder was stopped.
/// @throws Error naming the line that is malformed
[[nodiscard]] std::map<std::size_t, FrameMetadata> parse_frame_lines(const std::string& text,
                                                                     const std::string& place);

/// One line of a TUM list: seconds and a file.
struct TumEntry {
  double time_s = 0.0;
  std::string file;
};

/// @throws Error naming the line that is not `seconds file`
[[nodiscard]] std::vector<TumEntry> parse_tum_list(const std::string& text, const std::string& place);

/// The files of `folder` whose names end in one of `endings` (in any case; hidden files are left out), by
/// name, numbers in it by value: 2.png before 10.png; empty when there is no such folder. @throws Error when
/// it cannot be read
[[nodiscard]] std::vector<std::filesystem::path> image_files(const std::filesystem::path& folder,
                                                             const std::vector<std::string_view>& endings);

}  // namespace rva
