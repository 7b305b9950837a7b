#include "cli/finding_names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "core/path_text.hpp"

namespace rva::cli {
namespace {

bool is_in_a_group(int finding, const std::optional<PlanMatch>& match) {
  return match && std::ranges::any_of(match->groups, [&](const PlannedGroup& group) {
           return std::ranges::find(group.findings, finding) != group.findings.end();
         });
}

}  // namespace

void NamingFlags::add_to(CLI::App& command) {
  CLI::Option* const classify_flag =
      command.add_flag("--classify", classify,
                       "state what each finding may be, by the classifier that comes with the program");
  CLI::Option* const classifier_option =
      command
          .add_option(
              "--classifier", classifier,
              "state what each finding may be, by a classifier of your own: its card, beside its model")
          ->type_name("CARD.json")
          ->excludes(classify_flag);
  CLI::Option* const model_option =
      command
          .add_option("--model", model,
                      "an object detector, YOLO or SSD, that states what each finding may be")
          ->type_name("MODEL.onnx")
          ->excludes(classify_flag)
          ->excludes(classifier_option);
  CLI::Option* const labels_option =
      command.add_option("--labels", labels, "the names of its classes, one a line, in the model's order")
          ->type_name("LABELS.txt")
          ->needs(model_option);
  model_option->needs(labels_option);
  add_flags(command, options);
  ModelOptions::describe(options, [&](const auto& /*value*/, const OptionField& field) {
    command.get_option(fmt::format("--{}", field.name))->needs(model_option);
  });
}

void print_classes(const FindingClasses& classes, const std::optional<PlanMatch>& match) {
  for (const FindingClass& found : classes.findings) {
    if (is_in_a_group(found.finding, match)) continue;
    print("finding {} may be: {}{}\n", found.finding, printable(found.name),
          found.probability
              ? fmt::format(" ({:.0f} % for the most probable class)", 100.0 * *found.probability)
              : "");
  }
}

}  // namespace rva::cli
