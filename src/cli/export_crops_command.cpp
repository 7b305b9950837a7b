#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "classify/finding_planes.hpp"
#include "cli/commands.hpp"
#include "cli/printing.hpp"
#include "cli/recorded_inspection.hpp"
#include "cli/terminal_progress.hpp"
#include "core/file.hpp"
#include "core/file_origin.hpp"
#include "core/json_object.hpp"
#include "core/output_folder.hpp"
#include "inspect/labelled_crops.hpp"

namespace rva::cli {
namespace {

struct ExportCropsArguments {
  std::string data;
  std::vector<std::int64_t> inspections;
  std::string out;
  bool overwrite = false;
};

void run(const ExportCropsArguments& arguments) {
  std::vector<std::int64_t> numbers =
      arguments.inspections.empty() ? recorded_inspections(arguments.data) : arguments.inspections;
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  OutputFolder out(arguments.out, labelled_crop_files(),
                   arguments.overwrite ? Existing::replace : Existing::refuse);
  LabelledCrops all;
  const Progress progress = terminal_progress();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const LabelledCrops crops =
        write_labelled_crops(recorded_inspection(arguments.data, numbers[i]), arguments.data, out.path(""));
    all.crops.insert(all.crops.end(), crops.crops.begin(), crops.crops.end());
    all.shown.insert(all.shown.end(), crops.shown.begin(), crops.shown.end());
    all.planes += crops.planes;
    if (progress) progress("inspections", i + 1, numbers.size());
  }
  const nlohmann::ordered_json described{{"format", "rva-crops"},
                                         {"version", 1},
                                         {"provenance", provenance_json(time_of_making())},
                                         {"crops", all.crops}};
  write_file(out.path("crops.json"), json_file_text(described));
  const nlohmann::ordered_json training{{"run", {{"planes", finding_planes}, {"plane_px", plane_px}}},
                                        {"findings", all.shown}};
  write_file(out.path("findings.json"), json_file_text(training));
  write_file(out.path("planes.f16"), all.planes);
  out.commit();
  std::map<std::string, int> counts;
  for (const auto& crop : all.crops) ++counts[crop["label"]];
  for (const auto& [label, count] : counts) print("{}: {}\n", label, count);
  print("{} finding(s) of {} inspection(s), {} of them to train with\n{}\n", all.crops.size(), numbers.size(),
        all.shown.size(), arguments.out);
}

}  // namespace

void add_export_crops_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand(
      "export-crops",
      "writes the findings that people decided on as labelled pictures, to train a classifier");
  const auto arguments = std::make_shared<ExportCropsArguments>();
  add_data_folder(command, arguments->data);
  command
      .add_option("--inspection", arguments->inspections,
                  "number of an inspection; may be repeated; by default all")
      ->check(CLI::PositiveNumber)
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("N");
  command.add_option("--out", arguments->out, "folder of the pictures")->required()->type_name("CROPS");
  command.add_flag("--overwrite", arguments->overwrite, "replace earlier crops in CROPS");
  command.callback([arguments] { run(*arguments); });
}

}  // namespace rva::cli
