#include "cli/camera_check.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "camera/camera_history.hpp"
#include "cli/printing.hpp"
#include "cli/terminal_progress.hpp"
#include "core/error.hpp"
#include "core/json_object.hpp"

namespace fs = std::filesystem;

namespace rva::cli {
namespace {

/// How a quantity is printed, and what the user can do if it is not as usual.
struct Wording {
  const char* unit;
  double units;  // factor from the stored value to `unit`
  const char* advice;
};

const Wording& wording_of(std::string_view quantity) {
  static const std::map<std::string_view, Wording> wordings{
      {"noise", {"mm", 1.0, "clean its windows; check that light and exposure are as usual"}},
      {"measured", {"%", 100.0, "clean its windows; check that the scene is the usual one"}},
      {"drift", {"%", 100.0, "let it warm up and check again"}},
      {"distance", {"m", 1.0, "put it in front of the usual scene, in its usual position"}}};
  return wordings.at(quantity);
}

fs::path own_folder() {
  const auto variable = [](const char* name) {
    const char* const value = std::getenv(name);
    return fs::path(value == nullptr ? "" : value);
  };
  if (const fs::path state = variable("XDG_STATE_HOME"); state.is_absolute())
    return state / "rva" / "cameras";
  const fs::path home = variable("HOME");
  if (!home.is_absolute()) throw Error("--history", "there is no home folder to keep it in", "name a folder");
  return home / ".local" / "state" / "rva" / "cameras";
}

std::string limits_of(const CheckedQuantity& quantity) {
  const double units = wording_of(quantity.name).units;
  if (quantity.low && quantity.high)
    return fmt::format("{:.3g} to {:.3g}", units * *quantity.low, units * *quantity.high);
  if (quantity.low) return fmt::format("{:.3g} or more", units * *quantity.low);
  if (quantity.high) return fmt::format("{:.3g} or less", units * *quantity.high);
  return "-";
}

void print_for_a_person(const CameraCheck& check, const CameraJudgement& judgement,
                        const CheckStandardOptions& options) {
  print("{:<10}  {:>10}      {}\n", "", "now", "usual");
  for (const CheckedQuantity& quantity : judgement.quantities) {
    const Wording& wording = wording_of(quantity.name);
    print("{:<10}  {:>10.4g} {:<2}  {:<18} {}\n", quantity.name, wording.units * quantity.value, wording.unit,
          limits_of(quantity), quantity.fit ? "" : "not as usual");
  }
  if (check.temperature_c) print("{:<10}  {:>10.1f} C\n", "chip", *check.temperature_c);
  if (!judgement.known) {
    print("not known: {} of the {} earlier checks needed to judge it; this one is kept\n", judgement.earlier,
          options.least_checks);
    return;
  }
  if (judgement.fit) {
    print("fit: as in its {} earlier checks\n", judgement.earlier);
    return;
  }
  for (const CheckedQuantity& quantity : judgement.quantities)
    if (!quantity.fit) print("not fit: {}; {}\n", quantity.name, wording_of(quantity.name).advice);
}

}  // namespace

bool check_before_work(Camera& camera, const CameraCheckArguments& arguments) {
  check_options(arguments.options);
  const fs::path folder = arguments.history.empty() ? own_folder() : fs::path(arguments.history);
  const JudgedCheck judged =
      check_and_remember(camera, folder, arguments.frames, arguments.options, terminal_progress());
  if (arguments.json) {
    print("{}", json_file_text(json_of(judged)));
  } else {
    print_for_a_person(judged.check, judged.judgement, arguments.options);
  }
  return judged.judgement.fit;
}

}  // namespace rva::cli
