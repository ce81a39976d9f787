// The response of one particle to a triangle mesh: to the thickness, with Coulomb friction.
#pragma once

#include "kernels/contact.h"
#include "kernels/mesh_contact.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Between the cloth's frame at the start of the frame and the mesh's own.
template <class T>
WEFT_HD Vec3<T> into_mesh(const MeshCollider<T>& mesh, Vec3<T> x) {
  return back(mesh.rotation, x - mesh.translate);
}
template <class T>
WEFT_HD Vec3<T> from_mesh(const MeshCollider<T>& mesh, Vec3<T> x) {
  return mesh.rotation * x + mesh.translate;
}

/// `Position`: the displacement is kept as the previous position.
template <class T, bool Position, class Placement>
struct MeshResponse {
  const T* inverse_mass;
  ParticleBuffers<T> p;
  MeshCollider<T> mesh;
  Placement before, now;

  WEFT_HD void operator()(int i) const {
    if (!(inverse_mass[i] > T(0))) return;
    const Vec3<T> x0 = load(p.x_in, i), x = load(p.x_out, i);
    const Vec3<T> p0 = into_mesh(mesh, at_start(before, x0));
    const Vec3<T> p1 = into_mesh(mesh, at_start(now, x));
    const MeshContact<T> contact = mesh_contact(mesh.grid, p0, p1);
    if (!contact.hit) return;
    // The correction is turned, not the position: nothing is lost far from the mesh's origin.
    const Vec3<T> push = turned(now, mesh.rotation * (contact.to - p1));
    const Vec3<T> normal = turned(now, mesh.rotation * contact.normal);
    const Vec3<T> d = displacement_of(i, x), slip = d - carried(before, now, x);
    const T against = -dot(slip, normal), closing = against > T(0) ? against : T(0);
    const Vec3<T> along = slip + against * normal;
    const Vec3<T> drag = friction_against(along, mesh.surface.friction * closing);
    store(p.x_out, i, contact.stopped ? x + push : x + (push + drag));
    if constexpr (!Position) store(p.d_out, i, d + (closing * normal + drag));
  }

 private:
  WEFT_HD Vec3<T> displacement_of(int i, Vec3<T> x) const {
    if constexpr (Position) {
      return x - load(p.x_in, i);
    } else {
      return load(p.d_out, i);
    }
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
