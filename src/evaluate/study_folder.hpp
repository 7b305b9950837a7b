// Studies that are kept in a folder after each inspection, so that an interrupted one can be resumed.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/output_folder.hpp"
#include "core/progress.hpp"
#include "evaluate/moved_study.hpp"
#include "evaluate/study.hpp"

namespace rva {

/// The file of a study in its folder.
inline constexpr auto evaluation_file = "evaluation.json";

/// Writes evaluation.json: an evaluation with its provenance.
/// @param input the scene or recordings, as given; empty for inspections drawn by chance
void write_evaluation(nlohmann::ordered_json evaluation, const std::string& input, const OutputFolder& out);

/// The folder of a study, and what to do with an evaluation that is there.
struct StudyFolder {
  std::filesystem::path path;  ///< contains evaluation.json
  bool overwrite = false;      ///< replace an earlier evaluation
  bool resume = false;         ///< continue the evaluation in the folder, if there is one
};

/// Cameras and bays of a study, by the names that its file states.
struct StudySubject {
  std::string scene{};             ///< a scene file; empty for random wings, also where a camera was moved
  std::string cameras = "d435";    ///< as camera_of_each() takes them
  std::vector<std::string> bay{};  ///< as bay_features() takes them
};

/// Runs a study as run_study() and writes evaluation.json after each inspection.
/// @param options its `sensor` and `bay` are those of the subject
/// @return all inspections, those of an earlier run included
/// @throws as run_study(); UsageError for an unknown name, or if the evaluation to resume is of another
///         subject; ExistsError, before an inspection, if there is an evaluation that is not to be replaced;
///         Error if the folder cannot be written
[[nodiscard]] std::vector<SimulatedInspection> run_study_in(const StudyFolder& folder, StudyOptions options,
                                                            const StudySubject& subject,
                                                            const Progress& progress);

/// The same for run_moved_study(). A study is resumed only with the options that it was begun with, but for
/// the number of inspections.
[[nodiscard]] std::vector<MovedInspection> run_moved_study_in(const StudyFolder& folder,
                                                              MovedStudyOptions options,
                                                              const StudySubject& subject,
                                                              const Progress& progress);

}  // namespace rva
