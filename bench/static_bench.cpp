// Times static detection and its peers in one process; writes rows for build/bench.json.
//
//   rva_bench OUT.json            writes the rows of all C++ candidates
//   rva_bench --export DIR        writes the same frames and masks as files, for the peers in Python
#include <fmt/format.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>
#include <span>
#include <string>

#include "bench/frames.hpp"
#include "bench/interleaved.hpp"
#include "bench/read_only.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "depth/depth_statistics.hpp"
#include "depth/image_file.hpp"
#include "depth/mat_view.hpp"
#include "detect/findings/findings.hpp"
#include "detect/regions/regions.hpp"
#include "detect/thesis/gaussian.hpp"

namespace rva::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr int frame_counts[] = {10, 40, 100};
constexpr int blob_counts[] = {10, 100, 500, 5000};
constexpr int rounds = 15;
volatile std::uint64_t sink = 0;  // keeps results from being optimised away

// The two sets of frames of an inspection, and the sums of one way to compute their statistics. For every
// candidate, all sums are allocated and zero before timing starts.
class Ours {
 public:
  explicit Ours(std::span<const DepthImage> frames) : frames_(frames) {}
  void clear() {
    for (DepthStatistics& set : sets_) set.clear();
  }
  void sum() {
    const std::size_t half = frames_.size() / 2;
    sets_[0].add(frames_.first(half));
    sets_[1].add(frames_.last(half));
  }
  // Produces images, as numpy's mean() and std() do.
  void mean_and_deviation() {
    for (const DepthStatistics& set : sets_) {
      for (std::size_t i = 0; i < set.size(); ++i) {
        mean_[i] = set.mean(i);
        deviation_[i] = set.standard_deviation(i);
      }
    }
  }

 private:
  std::span<const DepthImage> frames_;
  std::array<DepthStatistics, 2> sets_{DepthStatistics(frames_[0].width(), frames_[0].height()),
                                       DepthStatistics(frames_[0].width(), frames_[0].height())};
  Image<double> mean_{frames_[0].width(), frames_[0].height()};
  Image<double> deviation_{frames_[0].width(), frames_[0].height()};
};

class OpenCv {
 public:
  OpenCv(std::span<const DepthImage> frames, int type) : frames_(frames) {
    for (cv::Mat& sum : sums_) sum.create(frames[0].height(), frames[0].width(), type);
  }
  void clear() {
    for (cv::Mat& sum : sums_) sum = cv::Scalar(0);
  }
  void sum() {
    for (std::size_t k = 0; k < frames_.size(); ++k) {
      const std::size_t set = k < frames_.size() / 2 ? 0 : 2;
      cv::accumulate(as_mat(frames_[k]), sums_[set]);
      cv::accumulateSquare(as_mat(frames_[k]), sums_[set + 1]);
    }
  }

 private:
  std::span<const DepthImage> frames_;
  std::array<cv::Mat, 4> sums_;
};

Json row(const std::string& name, double ours_ms, const std::string& peer, double peer_ms) {
  return {{"name", name},
          {"ours_ms", ours_ms},
          {"peer", peer},
          {"peer_ms", peer_ms},
          {"ratio", peer_ms / ours_ms}};
}

void bench_statistics(Json& rows, const std::vector<DepthImage>& all_frames) {
  for (const int count : frame_counts) {
    const std::span frames(all_frames.data(), 2UL * static_cast<std::size_t>(count));
    Ours ours(frames);
    OpenCv opencv_f64(frames, CV_64F);
    OpenCv opencv_f32(frames, CV_32F);
    const auto read_all = [&] {
      for (const DepthImage& frame : frames) sink = sink + read_only(frame.pixels());
    };
    const auto with_results = [&] {
      ours.sum();
      ours.mean_and_deviation();
    };
    std::vector<Candidate> candidates{{"ours", [&] { ours.sum(); }, [&] { ours.clear(); }},
                                      {"ours, with mean and deviation", with_results, [&] { ours.clear(); }},
                                      {"opencv-f64", [&] { opencv_f64.sum(); }, [&] { opencv_f64.clear(); }},
                                      {"opencv-f32", [&] { opencv_f32.sum(); }, [&] { opencv_f32.clear(); }},
                                      {"read-only", read_all}};
    time_interleaved(candidates, rounds);
    const std::string name = fmt::format("statistics/{}", count);
    for (std::size_t k = 2; k < candidates.size(); ++k) {
      rows.push_back(row(name, candidates[0].least_ms, candidates[k].name, candidates[k].least_ms));
    }
    // The numpy peer, which also computes mean and deviation, is timed by run.py.
    rows.push_back({{"name", name}, {"ours_ms", candidates[1].least_ms}, {"peer", "numpy"}});
  }
}

// Adds frames one at a time, as a camera delivers them; `ours_ms` is the time per frame.
void bench_live(Json& rows, const std::vector<DepthImage>& frames) {
  std::vector<Candidate> candidates{{"ours", [&] {
                                       DepthStatistics statistics(frames[0].width(), frames[0].height());
                                       for (const DepthImage& frame : frames) statistics.add(frame);
                                       sink = sink + statistics.frames();
                                     }}};
  time_interleaved(candidates, rounds);
  const double frame_ms = candidates[0].least_ms / static_cast<double>(frames.size());
  rows.push_back(row("live-frame", frame_ms, "budget", 1.0));
}

// The thesis' method is timed by run.py, for the blob counts that it can process in reasonable time. For the
// largest count, the peer is our own time at the previous count, which shows how cost grows.
void bench_regions(Json& rows) {
  double before_ms = 0.0;
  for (const int blobs : blob_counts) {
    const Mask mask = make_mask(blobs, static_cast<std::uint32_t>(blobs));
    std::vector<Candidate> candidates{{"ours", [&] { sink = sink + find_regions(mask, {}).size(); }}};
    time_interleaved(candidates, rounds);
    const std::string name = fmt::format("regions/{}", blobs);
    if (blobs == blob_counts[std::size(blob_counts) - 1]) {
      rows.push_back(row(name, candidates[0].least_ms, "ours-at-500", before_ms));
    } else {
      rows.push_back({{"name", name}, {"ours_ms", candidates[0].least_ms}, {"peer", "thesis"}});
    }
    before_ms = candidates[0].least_ms;
  }
}

// The time from the last frame in memory to boxes, for which the user waits at the end of the final capture.
void bench_last_frame(Json& rows, const std::vector<DepthImage>& frames) {
  constexpr std::size_t count = 40;
  DepthStatistics before(frames[0].width(), frames[0].height());
  before.add(std::span(frames.data(), count));
  DepthStatistics until_last(frames[0].width(), frames[0].height());
  until_last.add(std::span(frames.data() + count, count - 1));
  Intrinsics camera;
  camera.width = frames[0].width();
  camera.height = frames[0].height();
  camera.fx = camera.fy = 425.0;
  double least_ms = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round) {
    DepthStatistics after = until_last;
    std::vector<Candidate> candidate{{"ours", [&] {
                                        after.add(frames[2 * count]);
                                        const Comparison comparison =
                                            compare_gaussian(before, after, 0.0001, {});
                                        sink = sink + find_findings(comparison, {}, camera).size();
                                      }}};
    time_interleaved(candidate, 1);
    least_ms = std::min(least_ms, candidate[0].least_ms);
  }
  rows.push_back(row("last-frame-to-boxes", least_ms, "frame-at-30-hz", 1000.0 / 30.0));
}

void export_inputs(const std::filesystem::path& folder) {
  const std::vector<DepthImage> frames = make_frames(2 * frame_counts[2], 1);
  std::string bytes;
  for (const DepthImage& frame : frames) {
    bytes.append(reinterpret_cast<const char*>(frame.data()), frame.size() * sizeof(std::uint16_t));
  }
  write_file(folder / "frames.u16", bytes);
  for (const int blobs : blob_counts) {
    const Mask mask = make_mask(blobs, static_cast<std::uint32_t>(blobs));
    write_file(folder / fmt::format("mask-{}.png", blobs), encode_png(mask));
  }
}

void run(const std::filesystem::path& out) {
  const std::vector<DepthImage> frames = make_frames(2 * frame_counts[2], 1);
  Json rows = Json::array();
  cv::setNumThreads(1);
  bench_statistics(rows, frames);
  bench_live(rows, frames);
  bench_regions(rows);
  bench_last_frame(rows, frames);
  write_file(out, json_file_text(rows));
}

}  // namespace
}  // namespace rva::bench

int main(int argc, char** argv) {
  try {
    if (argc == 3 && std::strcmp(argv[1], "--export") == 0) {
      rva::bench::export_inputs(argv[2]);
      return 0;
    }
    if (argc == 2) {
      rva::bench::run(argv[1]);
      return 0;
    }
    fmt::print(stderr, "usage: rva_bench OUT.json | rva_bench --export DIR\n");
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "rva_bench: {}\n", error.what());
    return 1;
  }
}
