// A program outside of the source tree: prints what changed between two captures, a line for each finding.
#include <fmt/format.h>

#include "capture/capture.hpp"
#include "detect/detect.hpp"

int main(int, char** arguments) {
  rva::Captures before, after;
  before.push_back(rva::open_capture(arguments[1]));
  after.push_back(rva::open_capture(arguments[2]));
  const rva::SidesDetection result = rva::detect(before, after, rva::DetectOptions{}, {});
  for (const rva::Finding& finding : result.detection.findings.findings)
    fmt::print("{} {} {} {} {} {}\n", rva::name_of(finding.kind), finding.pixels.size(), finding.box.x,
               finding.box.y, finding.box.width, finding.box.height);
}
