// The outputs of object detectors, in the layouts in which YOLO and SSD models are exported.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace rva {

/// An object that a model reports in a picture.
struct ModelObject {
  cv::Rect2d box;            ///< pixels of the picture; may reach beyond its border
  int label = 0;             ///< number of its class, from 0
  double probability = 0.0;  ///< as the model states it, 0 to 1
};

/// What the outputs of a model are.
enum class OutputLayout {
  yolo_rows,  ///< YOLOv5 and v7: 1 x N x (5 + classes), each row cx, cy, width, height, objectness, classes
  yolo_columns,  ///< YOLOv8 and later: 1 x (4 + classes) x N, each column cx, cy, width, height, classes
  ssd,  ///< SSD: scores 1 x N x (1 + classes), the first for the background, and boxes 1 x N x 4, each
        ///< x0, y0, x1, y1 as shares of the picture
};

/// The layout of a model's outputs, by their sizes.
/// @param classes number of the model's labels, at least 1
/// @throws Error when the sizes fit no layout for so many classes, stating both
[[nodiscard]] OutputLayout layout_of(const std::vector<cv::Mat>& outputs, int classes,
                                     const std::string& model);

/// How much two boxes overlap: the intersection over the union, 0 to 1. Neither is empty.
[[nodiscard]] double overlap(const cv::Rect2d& one, const cv::Rect2d& other);

/// Reads the objects of a model's outputs, each with its most probable class. Of objects of one class that
/// overlap by more than 45 % (intersection over union), the most probable one remains.
/// @param outputs of float, in any order: scores of three classes are distinguished from boxes by their sums
/// of 1
/// @param size    the model's picture, pixels
/// @param least   objects that are less probable are left out, 0 to 1
/// @return the most probable first
/// @throws Error as layout_of()
[[nodiscard]] std::vector<ModelObject> objects_in(const std::vector<cv::Mat>& outputs, int classes,
                                                  cv::Size size, double least, const std::string& model);

}  // namespace rva
