#include "evaluate/study_folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/file_origin.hpp"
#include "core/json_object.hpp"
#include "core/output_folder.hpp"
#include "core/path_text.hpp"
#include "evaluate/evaluation_json.hpp"
#include "evaluate/moved_evaluation_json.hpp"
#include "scene/file/scene_file.hpp"
#include "sim/sensor/camera_models.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

/// The evaluation.json of a study, replaced after each inspection.
class EvaluationFile {
 public:
  explicit EvaluationFile(const StudyFolder& folder)
      : folder_(folder), existing_(folder.overwrite || folder.resume ? Existing::replace : Existing::refuse) {
    // Refuses at once, not after an inspection.
    (void)OutputFolder(folder_.path, {evaluation_file}, existing_);
  }

  [[nodiscard]] fs::path path() const { return folder_.path / evaluation_file; }
  [[nodiscard]] bool is_resumed() const {
    std::error_code ignored;
    return folder_.resume && fs::exists(path(), ignored);
  }

  void write(nlohmann::ordered_json evaluation, const std::string& input) {
    OutputFolder out(folder_.path, {evaluation_file}, existing_);
    write_evaluation(std::move(evaluation), input, out);
    out.commit();
    existing_ = Existing::replace;
  }

 private:
  const StudyFolder& folder_;
  Existing existing_;
};

std::string name_of_bay(const StudySubject& subject) {
  return fmt::format("{}", fmt::join(subject.bay, ","));
}

std::vector<SimulatedInspection> earlier(const EvaluationFile& file, const StudySubject& subject) {
  if (!file.is_resumed()) return {};
  Evaluation evaluation = evaluation_from_json(read_text_file(file.path()), printable(file.path()));
  if (evaluation.scene != subject.scene || evaluation.cameras != subject.cameras ||
      evaluation.bay != name_of_bay(subject))
    throw OptionError("resume", "the evaluation that is there is of another scene, bay or camera",
                      "give the options that it was begun with, or another folder");
  return std::move(evaluation.inspections);
}

// The options that a study keeps when it is resumed.
std::string begun_with(const MovedStudyOptions& options, const StudySubject& subject) {
  const PoseReturnOptions& pose_return = options.pose_return;
  return fmt::format(
      "return {}, cameras {}, first seed {}, captures {}, allowed {}{}{}{}{}{}", name_of(options.how),
      subject.cameras, options.first_seed, fmt::join(options.captures, ","), fmt::join(options.allowed, ","),
      options.octree ? ", octree" : "", options.lamp ? ", lamp" : "", options.color ? ", color" : "",
      subject.bay.empty() ? "" : ", bay " + name_of_bay(subject),
      pose_return.approaches > 1
          ? fmt::format(", approaches {} within {} deg", pose_return.approaches, pose_return.within_deg)
          : "");
}

}  // namespace

void write_evaluation(nlohmann::ordered_json evaluation, const std::string& input, const OutputFolder& out) {
  evaluation["provenance"] = provenance_json(time_of_making());
  if (!input.empty()) evaluation["provenance"]["input"] = printable(input);
  write_file(out.path(evaluation_file), json_file_text(evaluation));
}

std::vector<SimulatedInspection> run_study_in(const StudyFolder& folder, StudyOptions options,
                                              const StudySubject& subject, const Progress& progress) {
  std::optional<Scene> scene;
  if (!subject.scene.empty()) scene = load_scene(subject.scene);
  options.sensor = camera_of_each(subject.cameras);
  options.bay = bay_features(subject.bay);
  EvaluationFile file(folder);
  const auto keep = [&](const std::vector<SimulatedInspection>& inspections) {
    file.write(json_of(Evaluation{subject.scene, subject.cameras, name_of_bay(subject), inspections}),
               subject.scene);
  };
  return run_study(options, scene, earlier(file, subject), progress, keep);
}

std::vector<MovedInspection> run_moved_study_in(const StudyFolder& folder, MovedStudyOptions options,
                                                const StudySubject& subject, const Progress& progress) {
  check_options(options.pose_return);
  options.sensor = camera_of_each(subject.cameras);
  options.bay = bay_features(subject.bay);
  const std::string arguments = begun_with(options, subject);
  EvaluationFile file(folder);
  std::vector<MovedInspection> earlier;
  if (file.is_resumed())
    earlier = moved_inspections_from_json(read_text_file(file.path()), printable(file.path()), arguments);
  const auto keep = [&](const std::vector<MovedInspection>& inspections) {
    file.write(json_of(inspections, arguments), "");
  };
  return run_moved_study(options, std::move(earlier), progress, keep);
}

}  // namespace rva
