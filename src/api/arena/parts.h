// What some cloths have in arrays of their own, as a list. Which cloths have it, how much memory it
// takes, what `weft plan` says of it, what a kernel reads of it once per block and how its arrays
// are filled follow from the list. A part is a type with
//
//   part, name, flops              Part of state/stages.h; of `weft plan`, per particle
//   used(cloth)                    whether the cloth has it
//   number(cloth)                  the one number that its stage reads per block (ClothParams)
//   arrays(sim)                    its struct of views in Simulation
//   fill(cloth, first, stride, to) writes the cloth's entries, which are 0, from `first` on
//
//   remarks(cloth, out)            may be there: what the cloth asks of it and does not get
//
// and says with ClothRecord::parts_changed that its entries are to be written again.
#pragma once

#include <stdexcept>

#include "api/arena/forces.h"
#include "api/arena/tethers.h"
#include "base/host_memory.h"
#include "plan/cutter.h"
#include "plan/shape.h"

namespace weft::api {

template <class... Each>
struct PartList {
  static constexpr int count = sizeof...(Each);
  /// Calls `use` with every part.
  template <class Use>
  static void each(Use use) {
    (use(Each()), ...);
  }
};
using Parts = PartList<ForcesPart, TethersPart>;
static_assert(Parts::count == part_count, "a Part of state/stages.h is missing in the list");

constexpr int index_of(Part part) { return static_cast<int>(part); }

/// Bit k: the cloth has Part k.
inline uint32_t parts_of(const ClothRecord& cloth) {
  uint32_t bits = 0;
  Parts::each([&](auto part) {
    if (part.used(cloth)) bits |= 1u << index_of(part.part);
  });
  return bits;
}

inline Vector<scene::CookedDiagnostic> remarks_on(const ClothRecord& cloth) {
  Vector<scene::CookedDiagnostic> out;
  Parts::each([&](auto part) {
    if constexpr (requires { part.remarks(cloth, out); }) part.remarks(cloth, out);
  });
  return out;
}

/// Counts of `particles` particles that have a part, and of nothing else.
inline Counts counts_with(Part part, int64_t particles) {
  Counts counts{};
  counts.part[index_of(part)] = particles;
  return counts;
}

template <class T>
void price_parts_in(plan::WorldShape& shape) {
  Parts::each([&](auto part) {
    Simulation<T> sim{};
    plan::ArrayBytes bytes;
    part.arrays(sim).arrays(bytes, counts_with(part.part, block_size));
    shape.parts[index_of(part.part)] = {part.name, static_cast<double>(bytes.bytes()) / block_size,
                                        part.flops};
  });
}
inline void price_parts(plan::WorldShape& shape) {
  if (shape.precision == Precision::float64) {
    price_parts_in<double>(shape);
  } else {
    price_parts_in<float>(shape);
  }
}

/// The memory of one cloth's entries, which are whole blocks, in the arrays of a part.
struct Piece {
  char* at;
  size_t bytes;
};
struct Pieces {
  static constexpr int most = 16;
  Piece at[most];
  int count = 0;
  const Piece* begin() const { return at; }
  const Piece* end() const { return at + count; }
};
class PieceFinder {
 public:
  PieceFinder(int64_t first, int64_t count, int vector_stride)
      : first_(static_cast<size_t>(first / block_size)),
        count_(static_cast<size_t>(count / block_size)),
        stride_(static_cast<size_t>(vector_stride)) {}

  template <class Element>
  void operator()(Element*& view, int64_t per_block) {
    const size_t bytes = static_cast<size_t>(per_block) * sizeof(Element);
    add(view, first_ * bytes, count_ * bytes);
  }
  template <class T>
  void operator()(Vec3Array<T>& view, int64_t per_block, int64_t = 0) {
    const size_t bytes = static_cast<size_t>(per_block) * stride_ * sizeof(T);
    for (size_t c = 0; c < (stride_ > 1 ? 1 : 3); ++c) {
      add(view.data + c * view.pitch, first_ * bytes, count_ * bytes);
    }
  }
  const Pieces& pieces() const { return pieces_; }

 private:
  void add(const void* array, size_t from, size_t bytes) {
    if (pieces_.count == Pieces::most) throw std::length_error("a part of too many arrays");
    pieces_.at[pieces_.count++] = {static_cast<char*>(const_cast<void*>(array)) + from, bytes};
  }

  size_t first_, count_;  // blocks
  size_t stride_;
  Pieces pieces_;
};
template <class ThePart, class T>
Pieces pieces_of(ThePart part, Simulation<T>& sim, int64_t first, int64_t count,
                 int vector_stride) {
  PieceFinder finder(first, count, vector_stride);
  part.arrays(sim).arrays(finder, counts_with(part.part, block_size));
  return finder.pieces();
}

}  // namespace weft::api
