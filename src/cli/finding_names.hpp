// What findings may be, by the model that the user chose.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "classify/finding_classes.hpp"
#include "classify/naming_model.hpp"
#include "plan/plan_match.hpp"

namespace rva::cli {

/// The flags --classify, --classifier, --model, and those of a model.
struct NamingFlags : NamingChoice {
  /// Adds them to a command, of which they are members: they must outlive it.
  void add_to(CLI::App& command);
};

/// Prints what findings may be. Planned findings are printed as groups elsewhere, and left out here.
void print_classes(const FindingClasses& classes, const std::optional<PlanMatch>& match);

}  // namespace rva::cli
