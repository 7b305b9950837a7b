#include "scene/debris/debris_catalogue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <stdexcept>
#include <string>

#include "scene/solids/shapes.hpp"

namespace rva {
namespace {

constexpr std::uint64_t seed = 42;

SceneObject object_of(std::string_view kind, std::uint64_t shape_seed) {
  SceneObject object;
  object.parts = make_debris(kind, shape_seed);
  return object;
}

std::vector<Eigen::Vector3f> vertices_of(std::string_view kind, std::uint64_t shape_seed) {
  return world_mesh(object_of(kind, shape_seed)).vertices;
}

/// Weighs the parts by their volumes, each as a sum of tetrahedra over an apex far from the origin.
Eigen::Vector3d center_of_mass_m(const SceneObject& object) {
  const TriangleMesh mesh = world_mesh(object);
  const Eigen::Vector3d apex(1, 2, 3);
  Eigen::Vector3d moment(0, 0, 0);
  for (const auto& triangle : mesh.triangles) {
    Eigen::Matrix3d corners;
    for (int i = 0; i < 3; ++i)
      corners.col(i) = mesh.vertices[triangle[static_cast<std::size_t>(i)]].cast<double>();
    const double volume = (corners.colwise() - apex).determinant() / 6.0;
    moment += volume * (corners.rowwise().sum() + apex) / 4.0;
  }
  return moment / volume_m3(mesh);
}

class EveryKind : public testing::TestWithParam<DebrisKind> {};

TEST_P(EveryKind, IsMadeOfClosedSolidsThatFaceOutward) {
  std::size_t triangles = 0;
  for (const std::uint64_t shape_seed : {seed, seed + 1, seed + 2}) {
    triangles = 0;
    for (const Part& part : make_debris(GetParam().name, shape_seed)) {
      EXPECT_TRUE(is_closed(part.mesh));
      EXPECT_GT(volume_m3(part.mesh), 0.0);
      triangles += part.mesh.triangles.size();
    }
    EXPECT_LE(triangles, 6000U);
  }
  EXPECT_GE(triangles, 100U);
}

TEST_P(EveryKind, IsAsLargeAsStated) {
  const double size_mm = 1e3 * size_m(object_of(GetParam().name, seed)).maxCoeff();
  EXPECT_NEAR(size_mm, GetParam().size_mm, 0.01 * GetParam().size_mm);
  EXPECT_FALSE(GetParam().source.empty());
}

TEST_P(EveryKind, HasItsCentreOfMassAtTheOrigin) {
  const SceneObject object = object_of(GetParam().name, seed);
  EXPECT_LT(center_of_mass_m(object).norm(), 1e-4 * size_m(object).maxCoeff());
}

TEST_P(EveryKind, IsTheSameForTheSameSeed) {
  EXPECT_EQ(vertices_of(GetParam().name, seed), vertices_of(GetParam().name, seed));
}

std::string test_name(const testing::TestParamInfo<DebrisKind>& kind) {
  std::string name;
  for (const char letter : kind.param.name) name += std::isalnum(letter) != 0 ? letter : '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryKind, testing::ValuesIn(debris_catalogue()), test_name);

TEST(DebrisCatalogue, NamesEachKindOnce) {
  std::set<std::string_view> names;
  for (const DebrisKind& kind : debris_catalogue()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    ASSERT_NE(find_debris_kind(kind.name), nullptr);
    EXPECT_EQ(find_debris_kind(kind.name)->name, kind.name);
  }
}

TEST(DebrisCatalogue, LacksTheObjectsByWhichClassifiersAreTested) {
  for (const DebrisKind& kind : unlisted_kinds()) {
    EXPECT_EQ(find_debris_kind(kind.name), nullptr) << kind.name;
    const SceneObject object = object_of(kind.name, seed);
    for (const Part& part : object.parts) EXPECT_TRUE(is_closed(part.mesh) && volume_m3(part.mesh) > 0.0);
    if (kind.name != "random-shape") {
      EXPECT_NEAR(1e3 * size_m(object).maxCoeff(), kind.size_mm, 0.01 * kind.size_mm) << kind.name;
    }
  }
}

TEST(DebrisCatalogue, RandomShapesAreFrom8To200mmLarge) {
  double least_mm = 1000.0;
  double most_mm = 0.0;
  for (std::uint64_t shape_seed = 1; shape_seed <= 500; ++shape_seed) {
    const SceneObject object = object_of("random-shape", shape_seed);
    for (const Part& part : object.parts) ASSERT_TRUE(is_closed(part.mesh) && volume_m3(part.mesh) > 0.0);
    const double size_mm = 1e3 * size_m(object).maxCoeff();
    least_mm = std::min(least_mm, size_mm);
    most_mm = std::max(most_mm, size_mm);
  }
  EXPECT_GT(least_mm, 7.9);
  EXPECT_LT(least_mm, 9.0);
  EXPECT_GT(most_mm, 180.0);
  EXPECT_LT(most_mm, 200.1);
}

TEST(DebrisCatalogue, RefusesAnUnknownKind) {
  EXPECT_EQ(find_debris_kind("hammer"), nullptr);
  EXPECT_THROW(static_cast<void>(make_debris("hammer", seed)), std::out_of_range);
}

TEST(DebrisCatalogue, CollarsHaveTheDiametersOfTheThesis) {
  for (const double diameter_in : {0.27, 0.36, 0.44, 0.53}) {
    const std::string kind = "collar-" + std::to_string(diameter_in).substr(0, 4);
    const Eigen::Vector3d size_mm = 1e3 * size_m(object_of(kind, seed));
    EXPECT_NEAR(size_mm.x(), 25.4 * diameter_in, 0.005 * 25.4 * diameter_in) << kind;
    EXPECT_NEAR(size_mm.y(), 25.4 * diameter_in, 0.005 * 25.4 * diameter_in) << kind;
  }
}

TEST(DebrisCatalogue, SoftThingsDifferFromSeedToSeed) {
  for (const std::string_view kind : {"rag", "glove", "swarf", "wire", "tape"}) {
    EXPECT_NE(vertices_of(kind, 1), vertices_of(kind, 2)) << kind;
  }
  EXPECT_EQ(vertices_of("key", 1), vertices_of("key", 2));
}

}  // namespace
}  // namespace rva
