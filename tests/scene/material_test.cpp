#include "scene/material.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

namespace rva {
namespace {

TEST(Materials, AreFoundByTheirNames) {
  const std::vector<std::string_view> names = material_names();
  EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size());
  for (const std::string_view name : names) {
    EXPECT_EQ(find_material(name).name, name);
    EXPECT_EQ(find_material_or_null(name), &find_material(name));
  }
}

TEST(Materials, UnknownNameIsRefused) {
  EXPECT_EQ(find_material_or_null("unobtainium"), nullptr);
  EXPECT_THROW(static_cast<void>(find_material("unobtainium")), std::out_of_range);
}

TEST(Materials, GiveBackNoMoreLightThanTheyGet) {
  for (const std::string_view name : material_names()) {
    const Material& material = find_material(name);
    EXPECT_GT(material.infrared_albedo, 0.0) << name;
    EXPECT_GE(material.specular, 0.0) << name;
    EXPECT_LE(material.infrared_albedo + material.specular, 1.0) << name;
    EXPECT_LE(material.infrared_albedo * (1.0 + material.grain), 1.0) << name;
    EXPECT_GT(material.gloss, 0.0) << name;
    EXPECT_GT(material.grain_m, 0.0) << name;
  }
}

TEST(Materials, RubberIsDarkAndMetalShines) {
  EXPECT_LT(find_material("black-rubber").infrared_albedo, 0.06);
  EXPECT_GT(find_material("bare-aluminium").specular, find_material("bare-aluminium").infrared_albedo);
}

}  // namespace
}  // namespace rva
