#include "camera/capture_recording.hpp"

#include <fmt/format.h>

#include <exception>
#include <string>
#include <string_view>

#include "capture/folder/capture_writer.hpp"
#include "capture/mcap/mcap_capture_writer.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

// Fields of a replayed capture that are not part of the format are kept.
std::string extra_fields(const CaptureInfo& info) {
  return info.format == "rva-capture" && !info.source_json.empty() ? info.source_json : "{}";
}

/// One attempt to record, which counts the depth frames until a failure.
class Attempt {
 public:
  Attempt(const CaptureRecording& recording, const Progress& progress)
      : recording_(recording), progress_(progress) {}

  /// Calls `step`, and passes on its failure unless there are frames to keep.
  template <class Step>
  void run(const Step& step) {
    try {
      step();
    } catch (...) {
      if (!recording_.keep || frames_ == 0) throw;
      failure_ = std::current_exception();
    }
  }

  void record_into(CaptureSink& sink, Camera& camera) {
    recorded_ = record(camera, recording_.frames, sink,
                       [this](std::string_view step, std::size_t now, std::size_t total) {
                         frames_ = now;
                         if (progress_) progress_(step, now, total);
                       });
    if (recording_.lamp) record_lamp(camera, recording_.frames, sink, progress_);
  }

  [[nodiscard]] bool failed() const { return failure_ != nullptr; }
  [[nodiscard]] const Recorded& recorded() const { return recorded_; }

  /// Throws the failure, which states where the frames until then are kept.
  [[noreturn]] void throw_failure(const fs::path& kept) const {
    try {
      std::rethrow_exception(failure_);
    } catch (const Interrupted& interrupted) {
      throw RecordingInterrupted(interrupted, frames_, kept);
    } catch (const Error& error) {
      throw Error(error.source(),
                  fmt::format("{} ({} frame(s) until then are kept in {})", error.problem(), frames_,
                              printable(kept)),
                  error.remedy());
    }
  }

 private:
  const CaptureRecording& recording_;
  const Progress& progress_;
  std::size_t frames_ = 0;
  Recorded recorded_;
  std::exception_ptr failure_;
};

}  // namespace

Recorded record_capture(Camera& camera, const CaptureRecording& recording, OutputFolder& out,
                        const Progress& progress) {
  CaptureWriter writer(out.path(""), camera.info(), extra_fields(camera.info()));
  Attempt attempt(recording, progress);
  attempt.run([&] {
    attempt.record_into(writer, camera);
    out.commit();
  });
  if (attempt.failed()) attempt.throw_failure(out.keep_partial());
  return attempt.recorded();
}

Recorded record_capture(Camera& camera, const CaptureRecording& recording, const fs::path& file,
                        const Progress& progress) {
  Attempt attempt(recording, progress);
  replace_file(file, [&](const fs::path& partial) {
    McapCaptureWriter writer(partial, camera.info(), extra_fields(camera.info()));
    attempt.run([&] { attempt.record_into(writer, camera); });
    writer.finish();
  });
  if (attempt.failed()) attempt.throw_failure(file);
  return attempt.recorded();
}

}  // namespace rva
