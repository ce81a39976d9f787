// Masses from a density: a third of each triangle to each of its corners, and to a vertex without
// triangles the mean of the others.
#include "reference/effects.h"

namespace weft_tests {
namespace {

using DensityMass = BothPrecisions;

/// 1/m of a vertex: the acceleration under 1 N.
double inverse_mass(const Triangles& mesh, uint32_t vertex, double density,
                    weft::Precision precision) {
  TestWorld test(plain_world(precision));
  const std::vector<weft::VertexForce> force{{vertex, {0, 0, 1}}};
  weft::ClothDesc cloth;
  cloth.forces = force;
  const weft::ClothId id =
      add_mesh_cloth(test, mesh, slack(weft::Mass::Kind::density, density), cloth);
  return test.accelerations(id)[vertex].z;
}

TEST_P(DensityMass, OfALooseVertexIsTheMeanOfTheOthers) {
  // Two triangles of 1 and 3 m^2 with an edge in common; vertices 0 and 3 belong to none.
  Triangles mesh;
  mesh.vertices = {{9, 9, 9}, {0, 0, 0}, {2, 0, 0}, {7, 7, 7}, {0, 1, 0}, {0, -3, 0}};
  mesh.faces = {{1, 2, 4}, {1, 5, 2}};
  const double density = 0.3, whole = density * 4;
  const double within = GetParam() == weft::Precision::float64 ? 1e-12 : 1e-5;
  const std::pair<uint32_t, double> expected[] = {{1, density * 4 / 3}, {2, density * 4 / 3},
                                                  {4, density / 3},     {5, density},
                                                  {0, whole / 4},       {3, whole / 4}};
  for (const auto& [vertex, mass] : expected) {
    EXPECT_NEAR(inverse_mass(mesh, vertex, density, GetParam()) * mass, 1, within) << vertex;
  }
}

INSTANTIATE_TEST_SUITE_P(Precision, DensityMass, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests
