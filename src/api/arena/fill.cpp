#include "api/arena/fill.h"

#include <algorithm>
#include <cmath>

#include "api/arena/colours.h"
#include "api/arena/parts.h"
#include "api/context/vector_math.h"
#include "api/records/evaluation.h"
#include "api/arena/spring_fill.h"
#include "scene/fan.h"
#include "scene/grid.h"

namespace weft::api {

namespace {

/// Displacement of the substep before the present one.
double3 start_displacement(const ClothRecord& cloth, uint32_t v, double dt, double time) {
  if (const PinRecord* pin = cloth.pin_of(v)) {
    const bool led = pin->way.state != Way<double3>::State::none;
    if (pin->motion < 0 && !led) return {0, 0, 0};
    if (pin->motion < 0) {  // on its way from the start: as fast as the cloth
      return times(dt, cloth.velocities.empty() ? cloth.velocity : cloth.velocities[v]);
    }
    const PinMotion& m = cloth.motions[static_cast<size_t>(pin->motion)];
    return minus(motion_offset(m, time), motion_offset(m, time - dt));
  }
  if (std::isinf(cloth.cooked().mass_of(v))) return {0, 0, 0};
  return times(dt, cloth.velocities.empty() ? cloth.velocity : cloth.velocities[v]);
}

template <class T>
class ImageFiller {
 public:
  ImageFiller(const ArenaInput& in, int vector_stride, plan::DeviceArrays<T>& image)
      : in_(in), stride_(vector_stride), image_(image), sim_(image.sim), springs_(in, image.sim) {}

  void fill(double dt, double time) {
    for (const ClothRecord* cloth : in_.cloths) {
      std::fill_n(writable(sim_.block.cloth) + cloth->first() / block_size, slices_of(*cloth),
                  static_cast<int32_t>(cloth->place.cloths));
      fill_state(*cloth, dt, time);
      if (cloth->cooked().is_grid) {
        fill_presence(*cloth);
      } else if (sim_.triangles.start) {
        fill_fans(*cloth);
      }
      springs_.fill(*cloth);
      fill_survey_ranges(*cloth);
      Parts::each([&](auto part) {
        if (!part.used(*cloth)) return;
        part.fill(*cloth, cloth->place.part[index_of(part.part)], stride_, part.arrays(sim_));
      });
    }
    if (sim_.coloured.block != nullptr) {
      fill_spring_blocks(in_, writable(sim_.coloured.block));
    }
  }

 private:
  VectorWriter<T> vectors(const Vec3Array<T>& array) const { return {array, stride_}; }

  void fill_state(const ClothRecord& cloth, double dt, double time) {
    const bool position_form = in_.world->form == Form::position;
    const bool kept = image_.before.data != nullptr;
    const VectorWriter<T> x = vectors(sim_.x[0]), before = vectors(image_.before);
    const VectorWriter<T> d = vectors(position_form ? sim_.x[2] : sim_.d[0]);
    T* w = writable(sim_.inverse_mass);
    const uint32_t vertices = cloth.cooked().vertices;
    for (uint32_t v = 0; v < vertices; ++v) {
      const auto own = static_cast<size_t>(cloth.cooked().storage(v));
      const int64_t i = cloth.first() + static_cast<int64_t>(own);
      w[i] = cloth.pin_of(v) ? T(0) : static_cast<T>(1 / cloth.cooked().mass_of(v));
      if (cloth.moved) {
        x.set(i, narrow<T>(cloth.saved_x[own]));
        d.set(i, narrow<T>(cloth.saved_d[own]));
        if (kept) before.set(i, narrow<T>(cloth.saved_before[own]));
        continue;
      }
      const double3 at = minus(start_position(cloth, v), cloth.origin);
      const double3 by = start_displacement(cloth, v, dt, time);
      x.set(i, narrow<T>(at));
      if (kept) before.set(i, narrow<T>(at));
      d.set(i, narrow<T>(position_form ? minus(at, by) : by));
    }
  }

  /// Presence bits and, per block, whether any are missing.
  void fill_presence(const ClothRecord& cloth) {
    const scene::CookedGrid& grid = cloth.cooked().grid;
    const scene::StencilTable& table = scene::stencil_table(grid.stencil);
    const int radius = scene::stencil_radius(grid.stencil);
    const auto all = static_cast<uint16_t>((1u << table.count) - 1);
    uint16_t* presence = writable(sim_.presence) + cloth.first();
    uint8_t* inner = writable(sim_.block.inner) + cloth.first() / block_size;
    const int blocks = slices_of(cloth);
    for (int b = 0; b < blocks; ++b) inner[b] = 1;
    uint32_t v = 0;
    for (uint32_t row = 0; row < grid.rows; ++row) {
      const bool row_inside = row >= uint32_t(radius) && row + uint32_t(radius) < grid.rows;
      for (uint32_t column = 0; column < grid.columns; ++column, ++v) {
        const bool inside =
            row_inside && column >= uint32_t(radius) && column + uint32_t(radius) < grid.columns;
        uint16_t bits = all;
        if (!inside) {
          bits = 0;
          for (int k = 0; k < table.count; ++k) {
            if (scene::has_neighbour(grid, row, column, table.offset[k])) {
              bits = static_cast<uint16_t>(bits | (1u << k));
            }
          }
          inner[v / block_size] = 0;
        }
        presence[v] = bits;
      }
    }
    if (v % block_size != 0) inner[blocks - 1] = 0;  // padding has no neighbours
  }

  void fill_fans(const ClothRecord& cloth) {
    const scene::Fans fans = scene::build_fans(cloth.cooked());
    const int64_t corner = cloth.place.corners;
    int64_t* start = writable(sim_.triangles.start) + cloth.place.fan_slices;
    for (size_t s = 0; s < fans.slice_start.size(); ++s) start[s] = corner + fans.slice_start[s];
    int32_t* next = writable(sim_.triangles.next) + corner;
    int32_t* last = writable(sim_.triangles.last) + corner;
    for (size_t e = 0; e < fans.next.size(); ++e) {
      next[e] = cloth.first() + fans.next[e];
      last[e] = cloth.first() + fans.last[e];
    }
  }

  /// Which particles each group of the survey looks at.
  void fill_survey_ranges(const ClothRecord& cloth) {
    SurveyRange* range = writable(sim_.survey_ranges) + cloth.place.survey_groups;
    const int end = cloth.first() + static_cast<int>(cloth.cooked().vertices);
    for (int first = cloth.first(); first < end; first += survey_blocks * block_size) {
      *range++ = {first, std::min(end, first + survey_blocks * block_size)};
    }
  }

  const ArenaInput& in_;
  int stride_;
  plan::DeviceArrays<T>& image_;
  Simulation<T>& sim_;
  SpringFiller<T> springs_;
};

}  // namespace

template <class T>
void fill_image(const ArenaInput& in, int vector_stride, double dt, double time,
                plan::DeviceArrays<T>& image) {
  ImageFiller<T>(in, vector_stride, image).fill(dt, time);
}

template <class T>
void fill_params(const ArenaInput& in, Vector<ClothParams<T>>& out) {
  for (size_t c = 0; c < in.cloths.size(); ++c) {
    const ClothRecord& cloth = *in.cloths[c];
    ClothParams<T> p{};
    p.first = cloth.first();
    p.end = p.first + static_cast<int>(cloth.cooked().vertices);
    if (cloth.cooked().is_grid) {
      fill_grid_constants(cloth.cooked(), p);
    } else {
      p.stiffness[0] = static_cast<T>(cloth.cooked().stiffness.stretch);
    }
    p.drag = static_cast<T>(cloth.drag);
    p.spring_damping = static_cast<T>(cloth.spring_damping);
    const Drag model = cloth.drag_model == DragModel::central ? Drag::central : Drag::lagged;
    p.drag_model = static_cast<int>(cloth.drag > 0 ? model : Drag::none);
    p.starting = cloth.moved ? 0 : 1;
    if (cloth.scatters) {
      const FixedRange range = fixed_range(cloth);
      p.fixed_scale = static_cast<T>(range.scale);
      p.fixed_limit = static_cast<T>(range.scale * range.limit);
      p.half_scale = static_cast<T>(half_scale(cloth));
    }
    Parts::each([&](auto part) {
      const int k = index_of(part.part);
      const bool used = part.used(cloth);
      p.part[k] = used ? static_cast<int>(cloth.place.part[k] - cloth.place.particles) : no_part;
      p.part_number[k] = static_cast<T>(used ? part.number(cloth) : 0);
    });
    p.in_wind = in.wind != nullptr && in.shape.cloths[c].triangles ? 1 : 0;
    for (int k = 0; k < collider_shapes; ++k) {
      p.collider_first[k] = static_cast<int>(c) * static_cast<int>(in.shape.colliders[k]);
    }
    for (const ColliderRecord& collider : *in.colliders) {
      const bool met = collider.id && may_meet(cloth, collider);
      if (met) ++p.collider_count[static_cast<int>(collider.shape)];
    }
    out[c] = p;
  }
}

template void fill_image(const ArenaInput&, int, double, double, plan::DeviceArrays<float>&);
template void fill_image(const ArenaInput&, int, double, double, plan::DeviceArrays<double>&);
template void fill_params(const ArenaInput&, Vector<ClothParams<float>>&);
template void fill_params(const ArenaInput&, Vector<ClothParams<double>>&);

}  // namespace weft::api
