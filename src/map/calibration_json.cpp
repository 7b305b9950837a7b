#include <nlohmann/json.hpp>

#include "map/calibration.hpp"

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const ViewResiduals& residuals) {
  return {{"agreeing", residuals.share()}, {"residual_px", residuals.residual_px()}};
}

}  // namespace

Json json_of(const Calibration& calibration, std::span<const MapView> views) {
  const CalibrationResiduals sum = sum_of_residuals(calibration);
  Json json = {{"before", json_of(sum.before)},
               {"after", json_of(sum.after)},
               {"numbers", Json::array()},
               {"views", Json::array()}};
  for (const CalibratedNumber& number : calibration.numbers)
    json["numbers"].push_back({{"name", number.name},
                               {"unit", number.unit},
                               {"change", number.change},
                               {"deviation", number.deviation}});
  for (std::size_t i = 0; i < views.size(); ++i) {
    const CalibratedView& view = calibration.views[i];
    json["views"].push_back({{"capture", views[i].name},
                             {"pan_error_deg", view.joint_error.pan_deg},
                             {"tilt_error_deg", view.joint_error.tilt_deg},
                             {"neighbours", view.after.neighbours},
                             {"before", json_of(view.before)},
                             {"after", json_of(view.after)}});
  }
  return json;
}

}  // namespace rva
