#include "classify/labels.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"
#include "core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> labels_of(const std::string& text) {
  const test::TemporaryFolder folder;
  write_file(folder / "labels.txt", text);
  return read_labels(folder / "labels.txt");
}

std::string problem_of(const std::string& text) {
  try {
    static_cast<void>(labels_of(text));
  } catch (const Error& error) {
    return error.problem();
  }
  return {};
}

TEST(Labels, AreOneALineInOrder) {
  EXPECT_THAT(labels_of("bolt\nwire cutter\n"), ElementsAre("bolt", "wire cutter"));
  EXPECT_THAT(labels_of("Bohrer \xC3\xBC\r\n\tcollar \r\n\n \n"), ElementsAre("Bohrer \xC3\xBC", "collar"));
  EXPECT_THAT(labels_of("one"), ElementsAre("one"));
}

TEST(Labels, WhatIsNoListOfNamesIsRefused) {
  EXPECT_THAT(problem_of(""), HasSubstr("names no class"));
  EXPECT_THAT(problem_of("\n \n"), HasSubstr("names no class"));
  EXPECT_THAT(problem_of("bolt\n\nnut\n"), HasSubstr("line 2 is empty"));
  EXPECT_THAT(problem_of("bolt\nnut\nbolt\n"), HasSubstr("line 3"));
  EXPECT_THAT(problem_of("bolt\n\xFF\n"), HasSubstr("UTF-8"));
  EXPECT_THROW(static_cast<void>(read_labels("/nowhere/labels.txt")), Error);
}

}  // namespace
}  // namespace rva
