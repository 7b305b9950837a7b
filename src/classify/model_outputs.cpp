#include "classify/model_outputs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <span>

#include "core/error.hpp"

namespace rva {
namespace {

constexpr int yolo_row_head = 5;     // box and objectness
constexpr int yolo_column_head = 4;  // box
constexpr int corners = 4;
constexpr double overlap_of_one_object = 0.45;  // as in the programs that YOLO and SSD models come with

// The last two dimensions of an output, of which there is one picture.
struct Table {
  const cv::Mat* output = nullptr;
  int rows = 0;
  int columns = 0;

  [[nodiscard]] std::span<const float> row(int i) const {
    const auto wide = static_cast<std::size_t>(columns);
    return {output->ptr<float>() + static_cast<std::size_t>(i) * wide, wide};
  }
  [[nodiscard]] float at(int row, int column) const {
    return output->ptr<float>()[static_cast<std::ptrdiff_t>(row) * columns + column];
  }
};

std::optional<Table> table_of(const cv::Mat& output) {
  if (output.type() != CV_32F || !output.isContinuous()) return std::nullopt;
  if (output.dims == 2) return Table{&output, output.size[0], output.size[1]};
  if (output.dims == 3 && output.size[0] == 1) return Table{&output, output.size[1], output.size[2]};
  return std::nullopt;
}

std::string sizes_of(const std::vector<cv::Mat>& outputs) {
  std::vector<std::string> sizes;
  for (const cv::Mat& output : outputs)
    sizes.push_back(fmt::format("{}", fmt::join(output.size.p, output.size.p + output.dims, "x")));
  return fmt::format("{}", fmt::join(sizes, " and "));
}

// Whether each row sums to 1, as scores of all classes and the background do, and corners do not.
bool are_distributions(const Table& table) {
  constexpr double rounding = 0.01;
  for (int i = 0; i < table.rows; ++i) {
    const std::span<const float> row = table.row(i);
    if (!(std::abs(std::accumulate(row.begin(), row.end(), 0.0) - 1.0) < rounding)) return false;
  }
  return true;
}

// The scores and the boxes of an SSD model, in whichever order they come.
struct SsdTables {
  Table scores;
  Table boxes;
};

std::optional<SsdTables> ssd_tables(const std::vector<cv::Mat>& outputs, int classes) {
  if (outputs.size() != 2) return std::nullopt;
  const auto one = table_of(outputs[0]);
  const auto other = table_of(outputs[1]);
  if (!one || !other || one->rows != other->rows) return std::nullopt;
  const bool may_be = one->columns == classes + 1 && other->columns == corners;
  const bool may_be_swapped = other->columns == classes + 1 && one->columns == corners;
  if (!may_be && !may_be_swapped) return std::nullopt;
  // With three classes, both tables have four columns.
  const bool is_swapped =
      !may_be || (may_be_swapped && are_distributions(*other) && !are_distributions(*one));
  return is_swapped ? SsdTables{*other, *one} : SsdTables{*one, *other};
}

struct Best {
  int label = 0;
  double score = 0.0;
};

Best best_of(std::span<const float> scores) {
  const auto best = std::ranges::max_element(scores);
  return {static_cast<int>(best - scores.begin()), *best};
}

cv::Rect2d around(double x, double y, double width, double height) {
  return {x - 0.5 * width, y - 0.5 * height, width, height};
}

std::vector<ModelObject> of_yolo_rows(const Table& table) {
  std::vector<ModelObject> objects;
  for (int i = 0; i < table.rows; ++i) {
    const std::span<const float> row = table.row(i);
    const Best best = best_of(row.subspan(yolo_row_head));
    objects.push_back(
        {around(row[0], row[1], row[2], row[3]), best.label, row[yolo_row_head - 1] * best.score});
  }
  return objects;
}

std::vector<ModelObject> of_yolo_columns(const Table& table) {
  std::vector<ModelObject> objects;
  std::vector<float> scores(static_cast<std::size_t>(table.rows - yolo_column_head));
  for (int i = 0; i < table.columns; ++i) {
    for (std::size_t k = 0; k < scores.size(); ++k)
      scores[k] = table.at(yolo_column_head + static_cast<int>(k), i);
    const Best best = best_of(scores);
    objects.push_back(
        {around(table.at(0, i), table.at(1, i), table.at(2, i), table.at(3, i)), best.label, best.score});
  }
  return objects;
}

std::vector<ModelObject> of_ssd(const SsdTables& tables, cv::Size size) {
  std::vector<ModelObject> objects;
  for (int i = 0; i < tables.scores.rows; ++i) {
    const Best best = best_of(tables.scores.row(i).subspan(1));
    const std::span<const float> box = tables.boxes.row(i);
    const double width = size.width;
    const double height = size.height;
    const cv::Rect2d shown(width * box[0], height * box[1], width * (box[2] - box[0]),
                           height * (box[3] - box[1]));
    objects.push_back({shown, best.label, best.score});
  }
  return objects;
}

// A model that was exported or fed wrongly states numbers that are no probability or no box.
bool is_possible(const ModelObject& object) {
  const cv::Rect2d& box = object.box;
  return object.probability <= 1.0 && std::isfinite(box.x) && std::isfinite(box.y) &&
         std::isfinite(box.width) && std::isfinite(box.height) && box.width > 0.0 && box.height > 0.0;
}

// Non-maximum suppression.
std::vector<ModelObject> without_repetitions(std::vector<ModelObject> objects) {
  std::ranges::stable_sort(objects, std::greater{}, &ModelObject::probability);
  std::vector<ModelObject> kept;
  for (const ModelObject& object : objects) {
    const bool repeats = std::ranges::any_of(kept, [&](const ModelObject& earlier) {
      return earlier.label == object.label && overlap(earlier.box, object.box) > overlap_of_one_object;
    });
    if (!repeats) kept.push_back(object);
  }
  return kept;
}

}  // namespace

double overlap(const cv::Rect2d& one, const cv::Rect2d& other) {
  const double both = (one & other).area();
  return both / (one.area() + other.area() - both);
}

OutputLayout layout_of(const std::vector<cv::Mat>& outputs, int classes, const std::string& model) {
  if (ssd_tables(outputs, classes)) return OutputLayout::ssd;
  if (outputs.size() == 1) {
    const auto table = table_of(outputs.front());
    // A model of few objects may fit both; there are more objects than numbers for each.
    if (table && table->columns == yolo_row_head + classes) return OutputLayout::yolo_rows;
    if (table && table->rows == yolo_column_head + classes) return OutputLayout::yolo_columns;
  }
  throw Error(model,
              fmt::format("its outputs of {} are those of no YOLO or SSD detector of {} classes",
                          sizes_of(outputs), classes),
              "give the labels of this model, or a model that was exported with 1 x N x (5 + classes), "
              "1 x (4 + classes) x N, or scores and boxes");
}

std::vector<ModelObject> objects_in(const std::vector<cv::Mat>& outputs, int classes, cv::Size size,
                                    double least, const std::string& model) {
  std::vector<ModelObject> objects;
  switch (layout_of(outputs, classes, model)) {
    case OutputLayout::yolo_rows:
      objects = of_yolo_rows(*table_of(outputs.front()));
      break;
    case OutputLayout::yolo_columns:
      objects = of_yolo_columns(*table_of(outputs.front()));
      break;
    case OutputLayout::ssd:
      objects = of_ssd(*ssd_tables(outputs, classes), size);
      break;
  }
  std::erase_if(objects, [&](const ModelObject& object) {
    return !(object.probability >= least) || !is_possible(object);
  });
  return without_repetitions(std::move(objects));
}

}  // namespace rva
