// A substep into memory of its own: what the next one would do to each particle, for velocities
// that know of what holds it.
#pragma once

#include "api/arena/arena.h"
#include "api/arena/tethers.h"
#include "plan/cutter.h"

namespace weft::api {

template <class T>
class Probe {
 public:
  /// Once without colliders and once with them. `fetch` reads a whole array of vectors.
  template <class Fetch>
  Status run(ContextState& context, Frame<T> frame, Fetch fetch) {
    const Backend& backend = *context.backend;
    Vec3Array<T> x{}, d{};
    const auto cut = [&](char* base) {
      plan::Cutter cutter(base, static_cast<size_t>(backend.info().vector_stride));
      cutter(x, int64_t(frame.sim.blocks) * block_size);
      cutter(d, int64_t(frame.sim.blocks) * block_size);
      return cutter.bytes();
    };
    const size_t bytes = cut(nullptr);
    void* memory = backend.allocate(context.memory.hooks(), bytes);
    if (!memory) {
      return context.fail(
          Status::out_of_memory,
          text("no %zu bytes of device memory (velocities need them) make the scene smaller",
               bytes));
    }
    const auto give_back = [&](void* at) { backend.release(context.memory.hooks(), at, bytes); };
    const std::unique_ptr<void, decltype(give_back)> held(memory, give_back);
    cut(static_cast<char*>(memory));
    const Vec3Array<T>& moved = frame.position_form ? x : d;
    Frame<T> free = frame;
    free.sim.activity = nullptr;
    free.by_block = false;
    free.sim.contacts.state = nullptr;
    Status status = backend.probe(free, x, d);
    if (status == Status::ok) status = fetch(moved, without_);
    if (status == Status::ok) status = backend.probe(frame, x, d);
    if (status == Status::ok) status = fetch(moved, with_);
    return status;
  }

  /// Of one cloth in caller order; `now`: its positions in storage order, in the position form.
  void read(const ClothRecord& cloth, const Vec3<T>* now, Vector<Probed>& out) const {
    const bool tethered = TethersPart::used(cloth);
    const uint32_t vertices = cloth.cooked().vertices;
    out.resize(vertices);
    for (uint32_t v = 0; v < vertices; ++v) {
      const uint32_t s = cloth.cooked().storage(v);
      const size_t i = size_t(cloth.first()) + s;
      const Vec3<T>&with = with_[i], &without = without_[i];
      const bool same = with.x == without.x && with.y == without.y && with.z == without.z;
      out[v] = {{with.x, with.y, with.z}, tethered || !same};
      if (now) out[v].displacement = minus(out[v].displacement, {now[s].x, now[s].y, now[s].z});
    }
  }

 private:
  Vector<Vec3<T>> with_, without_;  ///< all particles, as the form keeps them
};

}  // namespace weft::api
