// Buffers of vertices that lie between canaries.
#include "run.h"

#include <algorithm>

namespace weft_tests::driver {

using weft::Attribute;
using weft::Format;
using weft::Status;

namespace {

weft::VertexLayout layout(Random& r, uint32_t vertices, uint32_t first) {
  weft::VertexLayout made;
  const Format places[] = {Format::f32x3, Format::f32x4, Format::f16x4};
  const Format normals[] = {Format::f32x3,    Format::f32x4,     Format::f16x4,
                            Format::snorm8x4, Format::snorm16x4, Format::oct16x2};
  const uint32_t wanted = r.from_to(1, 7);
  if (wanted & 1) made.position.format = r.one_of(places);
  if (wanted & 2) made.normal.format = r.one_of(normals);
  if (wanted & 4) made.last_position.format = r.one_of(places);
  Attribute* const all[] = {&made.position, &made.normal, &made.last_position};
  const bool interleaved = r.chance(0.6);
  uint32_t at = r.below(5), stride = r.below(7);
  for (const Attribute* a : all) stride += weft::size_of(a->format);
  for (Attribute* a : all) {
    if (a->format == Format::none) continue;
    a->offset = at;
    a->stride = interleaved ? stride : weft::size_of(a->format) + r.below(5);
    at += interleaved ? weft::size_of(a->format) : a->stride * (vertices + first) + r.below(5);
  }
  return made;
}

/// Behind the last byte of vertex `last`.
uint64_t end_of(const weft::VertexLayout& layout, uint64_t last) {
  uint64_t end = 0;
  for (const Attribute* a : {&layout.position, &layout.normal, &layout.last_position}) {
    if (a->format == Format::none) continue;
    end = std::max(end, a->offset + last * a->stride + weft::size_of(a->format));
  }
  return end;
}

void give_memory(Random& r, ModelOutput& output) {
  weft::OutputDesc& d = output.desc;
  const uint64_t last = uint64_t(d.first_vertex) + (output.vertices > 0 ? output.vertices - 1 : 0);
  const uint64_t end = output.vertices > 0 ? end_of(d.layout, last) : 1;
  output.memory = std::make_unique<std::vector<unsigned char>>(end + 2 * ModelOutput::guard);
  for (unsigned char& c : *output.memory) c = static_cast<unsigned char>(r.next());
  output.copy = std::make_unique<std::vector<unsigned char>>(*output.memory);
  d.memory = output.memory->data() + ModelOutput::guard;
  d.bytes = r.chance(0.7) ? end : 0;
}

/// Positions of floats must be those that are read, where both are finite.
void check_place(const ModelOutput& output, uint32_t vertex, const weft::double3& x) {
  const Attribute& a = output.desc.layout.position;
  if (a.format != Format::f32x3 && a.format != Format::f32x4) return;
  float got[3];
  const size_t at = size_t(output.desc.first_vertex + vertex) * a.stride + a.offset;
  std::memcpy(got, output.memory->data() + ModelOutput::guard + at, sizeof got);
  const weft::double3& o = output.desc.origin;
  const double want[3] = {x.x - o.x, x.y - o.y, x.z - o.z};
  for (int c = 0; c < 3; ++c) {
    if (!std::isfinite(want[c]) || std::fabs(want[c]) > 1e30) continue;
    const double hair = 1.2e-7 * std::fabs(want[c]) +
                        1e-12 * (std::fabs(x.x) + std::fabs(x.y) + std::fabs(x.z)) + 1e-37;
    require(std::fabs(double(got[c]) - want[c]) <= hair,
            "vertex %u is written at %.9g, and is at %.9g", vertex, double(got[c]), want[c]);
  }
}

}  // namespace

Outcome Run::bind_output(Random& r, ModelWorld& w) {
  if (w.outputs.size() >= 4 && !w.in_flight) return unbind_output(r, w);
  ModelOutput output;
  const ModelCloth* cloth = pick_cloth(r, w, output.cloth);
  output.vertices = cloth ? cloth->render_vertices : 2;
  weft::OutputDesc& d = output.desc;
  d.first_vertex = r.below(3);
  d.layout = layout(r, output.vertices, d.first_vertex);
  d.origin = r.chance(0.5) ? w.at : weft::double3{number(r, -10, 10), 0, 0};
  if (r.chance(0.8)) give_memory(r, output);
  Expect expect = !cloth ? Expect::handle : is_extreme_ ? Expect::any : Expect::ok;
  if (cloth && cloth->vertices > 1 && r.chance(0.2)) {
    expect = Expect::refusal;
    Attribute& a = d.layout.position.format != Format::none ? d.layout.position
                   : d.layout.normal.format != Format::none ? d.layout.normal
                                                            : d.layout.last_position;
    switch (r.below(7)) {
      case 0:
        a.stride = r.below(weft::size_of(a.format));
        break;
      case 1:
        a.format = Format(r.from_to(7, 255));
        break;
      case 2:
        d.layout.position.format = Format::snorm8x4;
        break;
      case 3:
        d.origin = r.bad_vector();
        break;
      case 4:
        d.layout = {};
        break;
      case 5:
        d.memory = nullptr;
        d.bytes = 1000;
        break;
      default:
        d.layout.last_position = d.layout.position = {Format::f32x3, 4, 12};
        d.layout.last_position.offset = 15;
    }
  }
  const weft::Result<weft::OutputId> made = w.world.bind_output(output.cloth, d);
  if (!made) return {made.status(), expect, 0};
  output.id = *made;
  remember(outputs_given_, output.id);
  w.outputs.push_back(std::move(output));
  return {Status::ok, expect, 0};
}

Outcome Run::unbind_output(Random& r, ModelWorld& w) {
  const bool is_there = !w.outputs.empty() && r.chance(0.85);
  const uint32_t at = r.below(w.outputs.size());
  const weft::OutputId id = is_there ? w.outputs[at].id : pick_other(r, w.dead_outputs, w.outputs);
  const Status status = w.world.unbind_output(id);
  if (status == Status::ok && is_there) {
    w.outputs.erase(w.outputs.begin() + at);
    w.dead_outputs.push_back(id);
  }
  return {status, is_there ? Expect::ok : Expect::handle, 0};
}

Outcome Run::set_output_memory(Random& r, ModelWorld& w) {
  const bool is_there = !w.outputs.empty() && r.chance(0.9);
  const uint32_t at = r.below(w.outputs.size());
  ModelOutput next;
  next.id = is_there ? w.outputs[at].id : pick_other(r, w.dead_outputs, w.outputs);
  if (is_there) {
    next.cloth = w.outputs[at].cloth;
    next.vertices = w.outputs[at].vertices;
    next.desc = w.outputs[at].desc;
  }
  next.desc.memory = nullptr;
  next.desc.bytes = 0;
  Expect expect = is_there ? Expect::ok : Expect::handle;
  if (is_there && r.chance(0.8)) give_memory(r, next);
  if (is_there && next.vertices > 0 && r.chance(0.2)) {
    expect = Expect::refusal;
    if (next.desc.memory && r.chance(0.7)) {
      const uint64_t whole = next.memory->size() - 2 * ModelOutput::guard;
      next.desc.bytes = whole > 1 ? whole - 1 : 1;
      if (next.desc.bytes == whole) expect = Expect::any;
    } else {
      next.desc.memory = nullptr;
      next.desc.bytes = r.from_to(1, 1000);
    }
  }
  const Status status = w.world.set_output_memory(next.id, next.desc.memory, next.desc.bytes);
  if (status == Status::ok && is_there) w.outputs[at] = std::move(next);
  return {status, expect, 0};
}

Outcome Run::write_outputs(Random& r, ModelWorld& w) {
  double alpha = r.chance(0.5) || !w.desc.interpolate ? 1 : r.one_of({0.0, 0.25, 0.999});
  Expect expect = Expect::ok;
  if (r.chance(0.15)) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    alpha = r.one_of({-0.1, 1.1, none, -std::numeric_limits<double>::infinity()});
    expect = Expect::refusal;
  } else if (!w.desc.interpolate && r.chance(0.1)) {
    alpha = 0.5;
    expect = Expect::refusal;
  }
  for (const ModelOutput& output : w.outputs) {
    if (!output.memory) expect = Expect::refusal;
  }
  const Status status = w.world.write_outputs(alpha);
  if (status != Status::ok) return {status, expect, 0};
  home_of(w).heap.left = Heap::endless;
  Digest digest;
  for (ModelOutput& output : w.outputs) {
    check_written(w, output, alpha);
    digest.add(output.memory->data(), output.memory->size());
    *output.copy = *output.memory;
  }
  return {status, expect, digest.value()};
}

void Run::check_written(ModelWorld& w, ModelOutput& output, double alpha) {
  const weft::OutputDesc& d = output.desc;
  std::vector<bool> mine(output.memory->size(), false);
  for (const Attribute* a : {&d.layout.position, &d.layout.normal, &d.layout.last_position}) {
    if (a->format == Format::none) continue;
    for (uint32_t v = 0; v < output.vertices; ++v) {
      const size_t at = ModelOutput::guard + a->offset + size_t(d.first_vertex + v) * a->stride;
      for (uint32_t b = 0; b < weft::size_of(a->format); ++b) mine[at + b] = true;
    }
  }
  for (size_t i = 0; i < mine.size(); ++i) {
    require(mine[i] || (*output.memory)[i] == (*output.copy)[i],
            "byte %zu beside the attributes was written", i);
  }
  const auto cloth = std::find_if(w.cloths.begin(), w.cloths.end(),
                                  [&](const ModelCloth& c) { return c.id == output.cloth; });
  // Of welded meshes the outputs have other vertices than what is read.
  if (alpha < 1 || cloth->vertices != cloth->render_vertices) return;
  std::vector<weft::double3> x(cloth->vertices);
  require(w.world.read_positions(cloth->id, x.data()) == Status::ok, "read_positions");
  for (uint32_t v = 0; v < output.vertices; ++v) check_place(output, v, x[v]);
}

}  // namespace weft_tests::driver
