#include "report/report_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <system_error>
#include <vector>

#include "classify/surroundings.hpp"
#include "depth/image_file.hpp"
#include "depth/mat_view.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

const cv::Scalar outline{255, 176, 32};
const cv::Scalar shadow{0, 0, 0};

// With a dark rim, so that it is seen on bright and on dark surfaces.
void draw_box(ColorImage& picture, const Box& box) {
  const cv::Rect around(box.x - 2, box.y - 2, box.width + 4, box.height + 4);
  cv::rectangle(as_mat(picture), around, shadow, 3);
  cv::rectangle(as_mat(picture), around, outline, 1);
}

void draw_label(ColorImage& picture, const Box& box, int label) {
  constexpr double scale = 0.6;
  constexpr int height_px = 16;
  const int below = box.y + box.height + height_px + 4;
  const cv::Point at(box.x, box.y > height_px + 4 ? box.y - 6 : below);
  const std::string text = std::to_string(label);
  cv::putText(as_mat(picture), text, at, cv::FONT_HERSHEY_SIMPLEX, scale, shadow, 4, cv::LINE_AA);
  cv::putText(as_mat(picture), text, at, cv::FONT_HERSHEY_SIMPLEX, scale, outline, 1, cv::LINE_AA);
}

// Half of each, where the stripes are.
void blend_stripes(const ColorImage& stripes, ColorImage& picture) {
  if (stripes.width() != picture.width() || stripes.height() != picture.height()) return;
  const auto mean = [](std::uint8_t one, std::uint8_t other) {
    return static_cast<std::uint8_t>((one + other) / 2);
  };
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const Rgb& stripe = stripes[i];
    Rgb& pixel = picture[i];
    if (stripe != Rgb{}) pixel = {mean(pixel.r, stripe.r), mean(pixel.g, stripe.g), mean(pixel.b, stripe.b)};
  }
}

// A link could lead to any file of this computer.
ColorImage read_without_links(const InspectionFolder& folder, const fs::path& file) {
  folder.require_no_links(file);
  return read_color(file);
}

Content figure(const Content& picture, std::string_view caption) {
  return Content::of(PartRole::figure, picture + Content::of(PartRole::caption, Content::text(caption)));
}

}  // namespace

// Empty where there is no colour. Every comparison has the other pictures.
const ColorImage& ComparisonPictures::picture(int view, const std::string& name) {
  const fs::path file = InspectionFolder::result_in(comparison_, view) / (name + ".png");
  const auto [known, is_new] = read_.try_emplace(file);
  std::error_code ignored;
  if (is_new && (!name.ends_with("color") || fs::exists(file, ignored)))
    known->second = read_without_links(folder_, file);
  return known->second;
}

// Whether the colour picture shows more than darkness.
bool ComparisonPictures::is_lit(int view) {
  constexpr int dark = 24;          // of 255
  constexpr std::size_t share = 5;  // a fifth of the pixels are brighter
  const auto [known, is_new] = lit_.try_emplace(view);
  if (!is_new) return known->second;
  const ColorImage& color = picture(view, "final_color");
  const auto bright = std::ranges::count_if(color.pixels(), [](const Rgb& pixel) {
    return std::max({pixel.r, pixel.g, pixel.b}) > dark;
  });
  known->second = !color.empty() && static_cast<std::size_t>(bright) * share > color.size();
  return known->second;
}

Content ComparisonPictures::view(int view, const std::vector<ObjectGroup>& groups) {
  ColorImage drawn = picture(view, is_lit(view) ? "final_color" : "final_depth");
  blend_stripes(picture(view, "not_inspected"), drawn);
  for (const ObjectGroup& group : groups)
    for (const ReviewedFinding* const finding : group.all)
      if (finding->view == view) draw_box(drawn, finding->finding.box);
  for (const ObjectGroup& group : groups)
    for (const ReviewedFinding* const finding : group.all)
      if (finding->view == view) draw_label(drawn, finding->finding.box, group.label);
  return Content::picture(drawn, fmt::format("View {} after the work; striped: not inspected", view + 1));
}

Content ComparisonPictures::before_and_after(const ReviewedFinding& finding) {
  std::vector<std::string> kinds{"depth"};
  if (is_lit(finding.view)) kinds.insert(kinds.begin(), "color");
  Content pictures;
  for (const std::string& kind : kinds)
    for (const auto& [side, moment] : {std::pair("initial_", "Before"), std::pair("final_", "After")}) {
      const ColorImage& whole = picture(finding.view, side + kind);
      if (whole.empty()) continue;
      const ColorImage part =
          part_of(whole, surroundings_of(finding.finding.box, whole.width(), whole.height()));
      const std::string caption = kind == "depth" ? fmt::format("{}, depth", moment) : moment;
      pictures += figure(Content::picture(part, caption), caption);
    }
  return Content::of(PartRole::close_ups, pictures);
}

Content marked_picture(const InspectionFolder& folder, const MarkedFinding& marked) {
  ColorImage drawn = read_without_links(folder, folder.path() / marked.picture);
  draw_box(drawn, marked.box);
  const ColorImage part = part_of(drawn, surroundings_of(marked.box, drawn.width(), drawn.height()));
  return Content::of(PartRole::close_ups,
                     figure(Content::picture(part, "Marked by a person"), "As it was marked"));
}

Content snapshot_picture(const InspectionFolder& folder, const Snapshot& snapshot) {
  return Content::picture(read_without_links(folder, folder.path() / snapshot.picture),
                          fmt::format("Snapshot {}", snapshot.number));
}

}  // namespace rva
