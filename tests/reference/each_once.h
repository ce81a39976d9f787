// The valence-6 grid with every spring evaluated once, as plain loops: an oracle for the gather's
// bits.
#pragma once

#include <cmath>
#include <vector>

namespace reference {

template <class T>
struct Triple {
  T x = 0, y = 0, z = 0;
};

/// Forces of `rows` x `columns` vertices at x. Contributions reach a vertex in ascending neighbour
/// index: first from the row above, then from the left, then what it evaluates itself.
template <class T>
std::vector<Triple<T>> forces_each_once(const std::vector<Triple<T>>& x, int rows, int columns,
                                        T stiffness, const T (&rest)[3]) {
  std::vector<Triple<T>> force(x.size());
  const auto pull = [&](int i, int j, T l0) {
    const T dx = x[size_t(j)].x - x[size_t(i)].x, dy = x[size_t(j)].y - x[size_t(i)].y,
            dz = x[size_t(j)].z - x[size_t(i)].z;
    const T length = std::sqrt(dx * dx + dy * dy + dz * dz);
    const T tension = length > 0 ? stiffness * (length - l0) / length : T(0);
    return Triple<T>{tension * dx, tension * dy, tension * dz};
  };
  const auto add = [&](int i, Triple<T> f) {
    Triple<T>& sum = force[size_t(i)];
    sum = {sum.x + f.x, sum.y + f.y, sum.z + f.z};
  };
  const auto subtract = [&](int i, Triple<T> f) {
    Triple<T>& sum = force[size_t(i)];
    sum = {sum.x - f.x, sum.y - f.y, sum.z - f.z};
  };
  std::vector<Triple<T>> right, below, across;
  right.resize(size_t(columns));
  below.resize(size_t(columns));
  across.resize(size_t(columns));
  for (int r = 0; r < rows; ++r) {
    const int first = r * columns;
    const bool inside = r + 1 < rows;
    for (int c = 0; c < columns; ++c) {
      const int i = first + c;
      const bool next = c + 1 < columns;
      right[size_t(c)] = next ? pull(i, i + 1, rest[0]) : Triple<T>{};
      below[size_t(c)] = inside ? pull(i, i + columns, rest[1]) : Triple<T>{};
      across[size_t(c)] = inside && next ? pull(i, i + columns + 1, rest[2]) : Triple<T>{};
    }
    for (int c = 0; c + 1 < columns; ++c) subtract(first + c + 1, right[size_t(c)]);
    for (int c = 0; c < columns; ++c) {
      add(first + c, right[size_t(c)]);
      add(first + c, below[size_t(c)]);
      add(first + c, across[size_t(c)]);
    }
    if (!inside) continue;
    for (int c = 0; c + 1 < columns; ++c) subtract(first + columns + c + 1, across[size_t(c)]);
    for (int c = 0; c < columns; ++c) subtract(first + columns + c, below[size_t(c)]);
  }
  return force;
}

}  // namespace reference
