// Fabrics and collider meshes.
#include "run.h"

namespace weft_tests::driver {

using weft::Status;

template <class Desc>
Outcome Run::cook(const Desc& desc, Expect expect, Home& home) {
  auto made = home.context.cook(desc);
  Outcome outcome{made.status(), expect, 0};
  if (!made) return outcome;
  if constexpr (std::is_same_v<Desc, weft::ColliderMeshDesc>) {
    Digest digest;
    digest.add(made->triangle_count());
    outcome.result = digest.value();
    if (home.meshes.size() >= 4) home.meshes.erase(home.meshes.begin());
    home.meshes.push_back(std::move(*made));
  } else {
    Digest digest;
    digest.add(made->spring_count());
    digest.add(made->triangle_count());
    digest.add(made->vertex_count());
    outcome.result = digest.value();
    if (home.fabrics.size() >= 6) home.fabrics.erase(home.fabrics.begin());
    home.fabrics.push_back(std::move(*made));
  }
  return outcome;
}

Outcome Run::cook_grid(Random& r, ModelWorld& w) {
  weft::GridDesc desc;
  desc.rows = r.from_to(1, 6);
  desc.columns = r.from_to(1, 6);
  desc.width = std::fabs(number(r, 0.3, 1.2)) + 1e-30;
  desc.height = std::fabs(number(r, 0.3, 1.2)) + 1e-30;
  desc.stencil = weft::Stencil(r.below(4));
  std::vector<double> masses;
  desc.material = material(r, desc.rows * desc.columns, masses);
  if (!r.chance(0.15)) return cook(desc, is_extreme_ ? Expect::any : Expect::ok, home_of(w));
  switch (r.below(6)) {
    case 0:
      desc.rows = 0;
      break;
    case 1:
      desc.columns = 0;
      break;
    case 2:
      desc.rows = desc.columns = 1u << r.from_to(16, 31);
      break;
    case 3:
      desc.width = r.chance(0.5) ? -1 : r.bad();
      break;
    case 4:
      desc.stencil = weft::Stencil(r.from_to(4, 255));
      break;
    default:
      spoil(r, desc.material);
  }
  return cook(desc, Expect::refusal, home_of(w));
}

Outcome Run::cook_mesh(Random& r, ModelWorld& w) {
  const uint32_t rows = r.from_to(1, 5), columns = r.from_to(1, 5);
  std::vector<weft::double3> x = sheet(r, rows, columns);
  std::vector<uint32_t> indices = triangles(rows, columns);
  if (r.chance(0.3)) {  // a seam: some corners get vertices of their own
    for (uint32_t& index : indices) {
      if (!r.chance(0.2)) continue;
      x.push_back(x[index]);
      index = static_cast<uint32_t>(x.size() - 1);
    }
  }
  weft::MeshDesc desc;
  Points points = stored(r, x);
  desc.positions = points.view;
  desc.indices = indices;
  desc.bend = r.chance(0.5);
  if (r.chance(0.4)) desc.weld_distance = r.chance(0.8) ? 1e-4 : r.real(0, 0.2);
  std::vector<double> masses;
  desc.material = material(r, desc.positions.count, masses);
  if (!r.chance(0.15)) return cook(desc, is_extreme_ ? Expect::any : Expect::ok, home_of(w));
  switch (indices.empty() ? r.from_to(3, 5) : r.below(6)) {
    case 0:
      indices[r.below(indices.size())] = desc.positions.count + r.below(9) * 1000;
      break;
    case 1:
      indices[0] = indices[1];
      break;
    case 2:
      desc.indices.count -= r.from_to(1, 2);
      break;
    case 3:
      desc.weld_distance = r.chance(0.5) ? -1 : r.bad();
      break;
    case 4:
      spoil(r, points);
      desc.positions = points.view;
      break;
    default:
      spoil(r, desc.material);
  }
  return cook(desc, Expect::refusal, home_of(w));
}

Outcome Run::cook_network(Random& r, ModelWorld& w) {
  const uint32_t vertices = r.from_to(1, 30);
  std::vector<weft::double3> x;
  for (uint32_t v = 0; v < vertices; ++v) x.push_back(r.vector(0.5));
  std::vector<weft::Spring> springs;
  for (uint32_t i = 0, count = vertices > 1 ? r.below(80) : 0; i < count; ++i) {
    weft::Spring s;
    s.a = r.chance(0.2) ? 0 : r.below(vertices);
    s.b = (s.a + 1 + r.below(vertices - 1)) % vertices;
    if (r.chance(0.2)) s.stiffness = std::fabs(number(r, 0, 100));
    if (r.chance(0.2)) s.rest_length = std::fabs(number(r, 0, 1));
    springs.push_back(s);
  }
  weft::NetworkDesc desc;
  Points points = stored(r, x);
  desc.positions = points.view;
  desc.springs = springs;
  std::vector<double> masses;
  desc.material = material(r, vertices, masses);
  if (!r.chance(0.15)) return cook(desc, is_extreme_ ? Expect::any : Expect::ok, home_of(w));
  switch (springs.empty() ? r.from_to(3, 5) : r.below(6)) {
    case 0:
      springs.back().b = springs.back().a;
      break;
    case 1:
      springs.front().a = vertices + r.below(5);
      break;
    case 2:
      springs.front().stiffness = r.chance(0.5) ? -3 : r.bad();
      break;
    case 3:
      desc.material.mass = {};
      desc.material.mass.kind = weft::Mass::Kind::density;
      break;
    case 4:
      spoil(r, points);
      desc.positions = points.view;
      break;
    default:
      spoil(r, desc.material);
  }
  return cook(desc, Expect::refusal, home_of(w));
}

Outcome Run::cook_collider(Random& r, ModelWorld& w) {
  std::vector<weft::double3> x;
  std::vector<uint32_t> indices;
  weft::ColliderMeshDesc desc;
  desc.closed = r.chance(0.5);
  if (desc.closed) {
    const weft::double3 half{r.real(0.1, 0.3), r.real(0.1, 0.3), r.real(0.1, 0.3)};
    for (int c = 0; c < 8; ++c) {
      x.push_back({c & 1 ? half.x : -half.x, c & 2 ? half.y : -half.y, c & 4 ? half.z : -half.z});
    }
    indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
               2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  } else {
    const uint32_t rows = r.from_to(2, 5), columns = r.from_to(2, 5);
    x = sheet(r, rows, columns);
    indices = triangles(rows, columns);
  }
  Points points = stored(r, x);
  desc.positions = points.view;
  desc.indices = indices;
  desc.thickness = std::fabs(number(r, 0.002, 0.02)) + 1e-12;
  if (r.chance(0.3)) desc.scale = std::fabs(number(r, 0.3, 3)) + 1e-12;
  if (!r.chance(0.15)) return cook(desc, is_extreme_ ? Expect::any : Expect::ok, home_of(w));
  switch (r.below(6)) {
    case 0:
      indices[r.below(indices.size())] = desc.positions.count + r.below(3) * 100000;
      break;
    case 1:
      desc.thickness = r.chance(0.5) ? 0 : r.bad();
      break;
    case 2:
      desc.scale = r.chance(0.5) ? -1 : r.bad();
      break;
    case 3:
      desc.indices.count -= r.from_to(1, 2);
      break;
    case 4:
      spoil(r, points);
      desc.positions = points.view;
      break;
    default:
      desc.closed = true;
      desc.indices.count -= 3;  // a hole
  }
  return cook(desc, Expect::refusal, home_of(w));
}

Outcome Run::read_fabric(Random& r, ModelWorld& w) {
  Home& home = home_of(w);
  const weft::Fabric fabric =
      home.fabrics.empty() ? weft::Fabric() : home.fabrics[r.below(home.fabrics.size())];
  Digest digest;
  const auto diagnostics = fabric.diagnostics();
  for (uint32_t i = 0; i < diagnostics.count; ++i) {
    require(diagnostics[i].text && diagnostics[i].text[0], "a diagnostic without a text");
    digest.add(diagnostics[i].element);
  }
  const uint64_t count = fabric.triangle_count();
  std::vector<uint32_t> particles(fabric.render_vertex_count());
  require(fabric.read_particles(particles.data()) == Status::ok, "read_particles");
  for (const uint32_t p : particles) require(p < fabric.vertex_count(), "particle %u", p);
  const uint64_t first = r.below(count + 1), some = r.below(count - first + 1);
  std::vector<uint32_t> indices(3 * some);
  const Status read = fabric.read_triangles(first, some, indices.data());
  require(read == Status::ok || !fabric.impl(), "read_triangles: %s", weft::to_string(read));
  for (const uint32_t v : indices) require(v < fabric.vertex_count(), "triangle of vertex %u", v);
  uint32_t none[3] = {7, 7, 7};
  const uint64_t beyond = r.chance(0.5) ? ~uint64_t(0) : count;
  require(fabric.read_triangles(beyond, 1, none) != Status::ok && none[0] == 7,
          "a triangle that is not there was read");
  require(fabric.read_triangles(1, ~uint64_t(0), none) != Status::ok && none[0] == 7,
          "endless triangles were read");
  digest.add(indices.data(), 4 * indices.size());
  book_.clear();
  return {Status::ok, Expect::ok, digest.value()};
}

Outcome Run::drop_fabric(Random& r, ModelWorld& w) {
  Home& home = home_of(w);
  if (!home.fabrics.empty()) {
    weft::Fabric& last = home.fabrics[r.below(home.fabrics.size())];
    const weft::Fabric copy = last;
    last = home.fabrics.back();
    home.fabrics.pop_back();
  }
  if (!home.meshes.empty() && r.chance(0.3)) home.meshes.pop_back();
  return {};
}

}  // namespace weft_tests::driver
