// Every field of the fabric descriptions with NaN, infinity, a negative or another impossible
// value: refused with a message that names it, and nothing made (HC25).
#include "reference/refusals.h"

#include <functional>

namespace weft_tests {
namespace {

const std::vector<weft::double3> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};

template <class Desc>
void expect_every_refusal(const Desc& good, const std::vector<BadField<Desc>>& fields) {
  TestWorld test;
  ASSERT_TRUE(test.context().cook(good)) << test.log();
  const uint64_t before = test.context().bytes_allocated();
  for (const BadField<Desc>& field : fields)
    for (double value : field.values) {
      SCOPED_TRACE(std::string(field.name) + " = " + std::to_string(value));
      Desc bad = good;
      field.set(bad, value);
      test.clear_log();
      expect_refusal(test, test.context().cook(bad).status(), {field.name});
    }
  EXPECT_EQ(test.context().bytes_allocated(), before);
}

/// The fields of Material, which every description has.
template <class Desc>
std::vector<BadField<Desc>> material_fields() {
  return {
      {"stretch", [](Desc& d, double v) { d.material.stiffness.stretch = v; }, negative},
      {"shear", [](Desc& d, double v) { d.material.stiffness.shear = v; }, negative},
      {"bend", [](Desc& d, double v) { d.material.stiffness.bend = v; }, negative},
      {"rest_length",
       [](Desc& d, double v) { d.material.rest_length = v; },
       {-0.5, -2, infinity, -infinity, not_a_number}},
      {"scale", [](Desc& d, double v) { d.material.scale = v; }, not_positive},
      {"mass", [](Desc& d, double v) { d.material.mass.value = v; }, not_positive},
      {"mass",
       [](Desc& d, double v) {
         d.material.mass.kind = weft::Mass::Kind::density;
         d.material.mass.value = v;
       },
       not_positive},
  };
}

TEST(BadGrid, EveryFieldIsChecked) {
  weft::GridDesc good;
  good.rows = 3;
  good.columns = 4;
  auto fields = material_fields<weft::GridDesc>();
  fields.push_back({"width", [](weft::GridDesc& d, double v) { d.width = v; }, not_positive});
  fields.push_back({"height", [](weft::GridDesc& d, double v) { d.height = v; }, not_positive});
  fields.push_back({"rows", [](weft::GridDesc& d, double) { d.rows = 0; }, {0}});
  fields.push_back({"columns", [](weft::GridDesc& d, double) { d.columns = 0; }, {0}});
  fields.push_back({"stencil",
                    [](weft::GridDesc& d, double v) { d.stencil = weft::Stencil(int(v)); },
                    {9, 255}});
  fields.push_back(
      {"kind",
       [](weft::GridDesc& d, double v) { d.material.mass.kind = weft::Mass::Kind(int(v)); },
       {3, 255}});
  expect_every_refusal(good, fields);
}

TEST(BadGrid, TooManyVerticesAreRefusedBeforeAnythingIsMade) {
  TestWorld test;
  weft::GridDesc grid;
  for (const auto& [rows, columns] : {std::pair{1u << 15, (1u << 15) + 1}, std::pair{1u << 31, 2u},
                                      std::pair{0xffffffffu, 0xffffffffu}}) {
    grid.rows = rows;
    grid.columns = columns;
    expect_refusal(test, test.context().cook(grid).status(), {"rows"});
  }
}

TEST(BadMesh, EveryFieldIsChecked) {
  const std::vector<uint32_t> triangle{0, 1, 2};
  weft::MeshDesc good;
  good.positions = weft::View<weft::double3>(corners);
  good.indices = triangle;
  expect_every_refusal(good, material_fields<weft::MeshDesc>());
}

TEST(BadNetwork, EveryFieldIsChecked) {
  const std::vector<weft::Spring> spring{{0, 1}};
  weft::NetworkDesc good;
  good.positions = weft::View<weft::double3>(corners);
  good.springs = spring;
  auto fields = material_fields<weft::NetworkDesc>();
  fields.pop_back();  // a network has no density: see the next test
  expect_every_refusal(good, fields);
}

TEST(BadNetwork, DensityNeedsTriangles) {
  TestWorld test;
  weft::NetworkDesc network;
  network.positions = weft::View<weft::double3>(corners);
  network.material.mass.kind = weft::Mass::Kind::density;
  expect_refusal(test, test.context().cook(network).status(), {"density"});
}

TEST(BadNetwork, SpringsNameTheirIndexAndField) {
  TestWorld test;
  weft::NetworkDesc network;
  network.positions = weft::View<weft::double3>(corners);
  for (double bad : not_finite) {
    const std::vector<weft::Spring> stiffness{{0, 1}, {1, 2, bad, -1}};
    const std::vector<weft::Spring> rest_length{{0, 1}, {1, 2, -1, bad}};
    network.springs = stiffness;
    expect_refusal(test, test.context().cook(network).status(), {"spring", "1", "stiffness"});
    network.springs = rest_length;
    expect_refusal(test, test.context().cook(network).status(), {"spring", "1", "rest"});
  }
}

TEST(BadPositions, NameTheirVertex) {
  const std::vector<uint32_t> triangle{0, 1, 2};
  TestWorld test;
  for (double bad : not_finite)
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<weft::double3> x = corners;
      (axis == 0 ? x[2].x : axis == 1 ? x[2].y : x[2].z) = bad;
      weft::NetworkDesc network;
      network.positions = weft::View<weft::double3>(x);
      expect_refusal(test, test.context().cook(network).status(), {"positions", "2"});
      weft::MeshDesc mesh;
      mesh.positions = weft::View<weft::double3>(x);
      mesh.indices = triangle;
      expect_refusal(test, test.context().cook(mesh).status(), {"positions", "2"});
      const std::vector<weft::float3> single{{0, 0, 0}, {1, 0, 0}, {float(bad), 1, 0}};
      network.positions = weft::View<weft::float3>(single);
      expect_refusal(test, test.context().cook(network).status(), {"positions", "2"});
    }
}

TEST(BadMasses, CountAndElementsAreChecked) {
  TestWorld test;
  weft::NetworkDesc network;
  network.positions = weft::View<weft::double3>(corners);
  network.material.mass.kind = weft::Mass::Kind::per_vertex;
  expect_refusal(test, test.context().cook(network).status(), {"mass"});
  const std::vector<double> two{1, 1};
  network.material.mass.values = two;
  expect_refusal(test, test.context().cook(network).status(), {"mass", "2", "3"});
  for (double bad : {0.0, -1.0, -infinity, not_a_number, 1e-320, 1e19}) {
    const std::vector<double> masses{1, bad, 1};
    network.material.mass.values = masses;
    expect_refusal(test, test.context().cook(network).status(), {"mass", "1"});
  }
}

TEST(BadViews, NullDataWithACountIsRefused) {
  TestWorld test;
  weft::NetworkDesc network;
  network.positions.count = 3;
  network.positions.stride = sizeof(weft::double3);
  expect_refusal(test, test.context().cook(network).status(), {"positions"});
  network.positions = weft::View<weft::double3>(corners);
  network.springs.count = 2;
  expect_refusal(test, test.context().cook(network).status(), {"springs"});
  weft::MeshDesc mesh;
  mesh.positions = weft::View<weft::double3>(corners);
  mesh.indices.count = 3;
  expect_refusal(test, test.context().cook(mesh).status(), {"indices"});
}

}  // namespace
}  // namespace weft_tests
