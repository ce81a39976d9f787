#include "api/records/outputs.h"

#include <algorithm>

#include "api/context/vector_math.h"
#include "base/message_host.h"
#include "scene/check.h"

namespace weft {

inline namespace v0 {

uint32_t size_of(Format format) noexcept {
  switch (format) {
    case Format::none:
      return 0;
    case Format::f32x3:
      return 12;
    case Format::f32x4:
      return 16;
    case Format::f16x4:
    case Format::snorm16x4:
      return 8;
    case Format::snorm8x4:
    case Format::oct16x2:
      return 4;
  }
  return 0;
}

}  // namespace v0

namespace api {

namespace {

struct Named {
  const char* name;
  const Attribute& attribute;
  bool is_position;
};

void check_attribute(const Named& a) {
  scene::check_choice(int(a.attribute.format), 7, a.name,
                      "none, f32x3, f32x4, f16x4, snorm8x4, snorm16x4, oct16x2");
  if (!is_wanted(a.attribute)) return;
  if (a.is_position && a.attribute.format > Format::f16x4) {
    throw InvalidInput(
        text("%s has a format of normals (positions are not in [-1, 1]) give f32x3, "
             "f32x4 or f16x4",
             a.name));
  }
  if (a.attribute.stride < size_of(a.attribute.format)) {
    throw InvalidInput(text("%s.stride is %u (its format takes %u bytes) give at least that",
                            a.name, a.attribute.stride, size_of(a.attribute.format)));
  }
}

/// First byte of the attribute of vertex i.
uint64_t at(const Attribute& a, uint64_t i) { return a.offset + i * a.stride; }

/// Whether any vertex's a shares a byte with any vertex's b.
bool overlap(const Attribute& a, const Attribute& b, uint32_t vertices) {
  const uint64_t size_a = size_of(a.format), size_b = size_of(b.format), last = vertices - 1;
  if (at(a, last) + size_a <= b.offset || at(b, last) + size_b <= a.offset) return false;
  for (uint64_t i = 0; i < vertices; ++i) {
    const uint64_t begin = at(a, i);
    // Of the b the last that begins at or before `begin`, and the one behind it.
    const uint64_t before = begin < b.offset ? 0 : std::min(last, (begin - b.offset) / b.stride);
    for (uint64_t j = before; j <= std::min(last, before + 1); ++j) {
      if (at(b, j) < begin + size_a && begin < at(b, j) + size_b) return true;
    }
  }
  return false;
}

}  // namespace

void check_output(const OutputDesc& desc, uint32_t vertices) {
  const Named all[] = {{"layout.position", desc.layout.position, true},
                       {"layout.normal", desc.layout.normal, false},
                       {"layout.last_position", desc.layout.last_position, true}};
  bool any = false;
  for (const Named& a : all) {
    check_attribute(a);
    any |= is_wanted(a.attribute);
  }
  if (!any) {
    throw InvalidInput(
        "layout names no attribute (the output would write nothing) give a position, a normal or a "
        "last_position");
  }
  checked_vector(desc.origin, "origin");
  for (const Named& a : all) {
    for (const Named* b = &a + 1; b != all + 3; ++b) {
      if (vertices == 0 || !is_wanted(a.attribute) || !is_wanted(b->attribute)) continue;
      if (overlap(a.attribute, b->attribute, vertices)) {
        throw InvalidInput(
            text("%s and %s overlap (one would overwrite the other) give them other "
                 "offsets or strides",
                 a.name, b->name));
      }
    }
  }
  if (desc.memory || desc.bytes > 0) check_memory(desc, vertices);
}

void check_memory(const OutputDesc& desc, uint32_t vertices) {
  if (!desc.memory) {
    throw InvalidInput(
        "memory is null (vertices must go somewhere) give the address of the buffer");
  }
  if (desc.bytes == 0 || vertices == 0) return;
  for (const Attribute* a :
       {&desc.layout.position, &desc.layout.normal, &desc.layout.last_position}) {
    if (!is_wanted(*a)) continue;
    const uint64_t end = at(*a, uint64_t(desc.first_vertex) + vertices - 1) + size_of(a->format);
    if (end > desc.bytes) {
      throw InvalidInput(
          text("bytes is %llu (vertex %llu ends at byte %llu) give a larger buffer",
               static_cast<unsigned long long>(desc.bytes),
               static_cast<unsigned long long>(uint64_t(desc.first_vertex) + vertices - 1),
               static_cast<unsigned long long>(end)));
    }
  }
}

}  // namespace api
}  // namespace weft
