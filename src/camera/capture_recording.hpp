// Records a camera into a capture folder or an MCAP file that appears whole, or keeps what a device gave
// before a failure.
#pragma once

#include <cstddef>
#include <filesystem>
#include <utility>

#include "camera/camera.hpp"
#include "camera/recording.hpp"
#include "core/interrupt.hpp"
#include "core/output_folder.hpp"
#include "core/progress.hpp"

namespace rva {

/// What to record, and what to do with it after a failure.
struct CaptureRecording {
  std::size_t frames = 40;  ///< depth frames, 1 or more
  bool lamp = false;  ///< infrared images of as many frames under the lamp, too; the camera must have one
  /// Keep the depth frames recorded until a failure: those of a device cannot be recorded a second time.
  bool keep = false;
};

/// The user stopped a recording whose frames until then are kept.
class RecordingInterrupted : public Interrupted {
 public:
  /// @param frames that are kept, 1 or more
  /// @param kept   the folder or file that contains them
  RecordingInterrupted(const Interrupted& cause, std::size_t frames, std::filesystem::path kept)
      : Interrupted(cause), frames_(frames), kept_(std::move(kept)) {}

  /// The number of depth frames that are kept.
  [[nodiscard]] std::size_t frames() const { return frames_; }
  /// The folder or file that contains them.
  [[nodiscard]] const std::filesystem::path& kept() const { return kept_; }

 private:
  std::size_t frames_;
  std::filesystem::path kept_;
};

/// Records a capture folder as record() and record_lamp() do, and commits it. After a failure, frames to keep
/// stay beside the target (OutputFolder::keep_partial()).
/// @param out of capture_files(), with Remains::keep where frames are to be kept
/// @throws Error, UsageError, Interrupted as record() and record_lamp(), and as OutputFolder::commit(). Where
///         frames are kept, the Error states how many and in which folder, and the interruption is a
///         RecordingInterrupted
Recorded record_capture(Camera& camera, const CaptureRecording& recording, OutputFolder& out,
                        const Progress& progress);

/// Records an MCAP file in the same way, and replaces an earlier file of that name. After a failure, frames
/// to keep are in `file`; without any, it is unchanged.
Recorded record_capture(Camera& camera, const CaptureRecording& recording, const std::filesystem::path& file,
                        const Progress& progress);

}  // namespace rva
