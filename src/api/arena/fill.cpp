#include "api/arena/fill.h"

#include <algorithm>
#include <cmath>

#include "api/records/evaluation.h"
#include "api/arena/spring_fill.h"
#include "scene/fan.h"
#include "scene/grid.h"

namespace weft::api {

namespace {

/// Displacement of the substep before the present one.
double3 start_displacement(const ClothRecord& cloth, uint32_t v, double dt, double time) {
  if (const PinRecord* pin = cloth.pin_of(v)) {
    if (pin->motion < 0) return {0, 0, 0};
    const PinMotion& m = cloth.motions[static_cast<size_t>(pin->motion)];
    return minus(motion_offset(m, time), motion_offset(m, time - dt));
  }
  if (std::isinf(cloth.cooked().mass_of(v))) return {0, 0, 0};
  return times(dt, cloth.velocities.empty() ? cloth.velocity : cloth.velocities[v]);
}

/// Where the motion of a pin has taken it by `time`.
double3 start_offset(const ClothRecord& cloth, uint32_t v, double time) {
  const PinRecord* pin = cloth.pin_of(v);
  if (!pin || pin->motion < 0) return {0, 0, 0};
  return motion_offset(cloth.motions[static_cast<size_t>(pin->motion)], time);
}

template <class T>
class ImageFiller {
 public:
  ImageFiller(const ArenaInput& in, const plan::Layout& layout, int step, char* image)
      : in_(in), layout_(layout), step_(step), image_(image), springs_(in, layout, image) {}

  void fill(double dt_before, double time) {
    for (size_t c = 0; c < in_.cloths.size(); ++c) {
      ClothRecord& cloth = *in_.cloths[c];
      cloth.params = static_cast<int>(c);
      cloth.first = next_;
      for (int b = 0; b < slices_of(cloth); ++b) {
        array<int32_t>(layout_.block_cloth)[next_ / block_size + b] = cloth.params;
      }
      fill_state(cloth, dt_before, time);
      if (cloth.cooked().is_grid) {
        fill_presence(cloth);
      } else if (layout_.triangle_start != plan::absent) {
        fill_fans(cloth);
      }
      springs_.fill(cloth);
      fill_forces(cloth);
      if (!cloth.cooked().is_grid) slice_ += slices_of(cloth);
      next_ += slices_of(cloth) * block_size;
    }
  }

 private:
  template <class E>
  E* array(size_t offset) const {
    return reinterpret_cast<E*>(image_ + offset);
  }
  VectorWriter<T> vectors(const plan::VectorArray& a) const { return {a, step_, image_}; }

  void fill_state(const ClothRecord& cloth, double dt_before, double time) {
    const bool position_form = in_.world->form == Form::position;
    const VectorWriter<T> x = vectors(layout_.x[0]);
    const bool kept = layout_.before.offset != plan::absent;
    const VectorWriter<T> before = vectors(kept ? layout_.before : layout_.x[0]);
    const VectorWriter<T> d = vectors(position_form ? layout_.x[2] : layout_.d[0]);
    T* w = array<T>(layout_.inverse_mass);
    const uint32_t vertices = cloth.cooked().vertices;
    for (uint32_t v = 0; v < vertices; ++v) {
      const int64_t i = cloth.first + int64_t(cloth.cooked().storage(v));
      w[i] = cloth.pin_of(v) ? T(0) : static_cast<T>(1 / cloth.cooked().mass_of(v));
      if (cloth.moved) {
        x.set(i, narrow<T>(cloth.saved_x[size_t(i - cloth.first)]));
        d.set(i, narrow<T>(cloth.saved_d[size_t(i - cloth.first)]));
        if (kept) before.set(i, narrow<T>(cloth.saved_before[size_t(i - cloth.first)]));
        continue;
      }
      const double3 at =
          plus(minus(start_position(cloth, v), cloth.origin), start_offset(cloth, v, time));
      const double3 by = start_displacement(cloth, v, dt_before, time);
      x.set(i, narrow<T>(at));
      if (kept) before.set(i, narrow<T>(at));
      d.set(i, narrow<T>(position_form ? minus(at, by) : by));
    }
  }

  /// Presence bits and, per block, whether any are missing.
  void fill_presence(const ClothRecord& cloth) {
    const scene::GridShape& grid = cloth.cooked().grid;
    const scene::StencilTable& table = scene::stencil_table(grid.stencil);
    const int reach = scene::stencil_reach(grid.stencil);
    const auto all = static_cast<uint16_t>((1u << table.count) - 1);
    uint16_t* presence = array<uint16_t>(layout_.presence) + cloth.first;
    uint8_t* inner = array<uint8_t>(layout_.block_inner) + cloth.first / block_size;
    const int blocks = slices_of(cloth);
    for (int b = 0; b < blocks; ++b) inner[b] = 1;
    uint32_t v = 0;
    for (uint32_t row = 0; row < grid.rows; ++row) {
      const bool row_inside = row >= uint32_t(reach) && row + uint32_t(reach) < grid.rows;
      for (uint32_t column = 0; column < grid.columns; ++column, ++v) {
        const bool inside =
            row_inside && column >= uint32_t(reach) && column + uint32_t(reach) < grid.columns;
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
    int64_t* start = array<int64_t>(layout_.triangle_start) + slice_;
    for (size_t s = 0; s < fans.slice_start.size(); ++s) start[s] = corner_ + fans.slice_start[s];
    int32_t* next = array<int32_t>(layout_.triangle_next) + corner_;
    int32_t* last = array<int32_t>(layout_.triangle_last) + corner_;
    for (size_t e = 0; e < fans.next.size(); ++e) {
      next[e] = cloth.first + fans.next[e];
      last[e] = cloth.first + fans.last[e];
    }
    corner_ += static_cast<int64_t>(fans.next.size());
  }

  void fill_forces(const ClothRecord& cloth) {
    if (cloth.forces.empty()) return;
    const VectorWriter<T> force = vectors(layout_.force);
    for (const VertexForce& f : cloth.forces) {
      force.set(forced_ + int64_t(cloth.cooked().storage(f.vertex)), narrow<T>(f.force));
    }
    forced_ += slices_of(cloth) * block_size;
  }

  const ArenaInput& in_;
  const plan::Layout& layout_;
  int step_;
  char* image_;
  SpringFiller<T> springs_;
  int next_ = 0, slice_ = 0, forced_ = 0;
  int64_t corner_ = 0;
};

}  // namespace

template <class T>
void fill_image(const ArenaInput& in, const plan::Layout& layout, int particle_step,
                double dt_before, double time, char* image) {
  ImageFiller<T>(in, layout, particle_step, image).fill(dt_before, time);
}

template <class T>
void fill_params(const ArenaInput& in, std::vector<ClothParams<T>>& out) {
  int forced = 0;
  for (size_t c = 0; c < in.cloths.size(); ++c) {
    const ClothRecord& cloth = *in.cloths[c];
    ClothParams<T> p{};
    p.first = cloth.first;
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
    p.force_offset = cloth.forces.empty() ? no_forces : forced - cloth.first;
    if (!cloth.forces.empty()) forced += slices_of(cloth) * block_size;
    p.in_wind = in.wind != nullptr && in.shape.cloths[c].triangles ? 1 : 0;
    for (int k = 0; k < collider_shapes; ++k) {
      p.collider_count[k] = static_cast<int>(in.shape.colliders[k]);
      p.collider_first[k] = static_cast<int>(c) * p.collider_count[k];
    }
    out[c] = p;
  }
}

void fill_survey_ranges(const ArenaInput& in, const plan::Layout& layout, char* image) {
  auto* range = reinterpret_cast<SurveyRange*>(image + layout.survey_ranges);
  for (const ClothRecord* cloth : in.cloths) {
    const int end = cloth->first + static_cast<int>(cloth->cooked().vertices);
    for (int first = cloth->first; first < end; first += survey_blocks * block_size) {
      *range++ = {first, std::min(end, first + survey_blocks * block_size)};
    }
  }
}

template void fill_image<float>(const ArenaInput&, const plan::Layout&, int, double, double, char*);
template void fill_image<double>(const ArenaInput&, const plan::Layout&, int, double, double,
                                 char*);
template void fill_params(const ArenaInput&, std::vector<ClothParams<float>>&);
template void fill_params(const ArenaInput&, std::vector<ClothParams<double>>&);

}  // namespace weft::api
