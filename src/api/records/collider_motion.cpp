#include "api/records/collider_motion.h"

#include "scene/trigonometry.h"

namespace weft::api {

namespace {

void rows_of(const Quaternion& q, double3* rows) {
  const auto [w, x, y, z] = q;
  rows[0] = {1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)};
  rows[1] = {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)};
  rows[2] = {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)};
}

double inner(const Quaternion& a, const Quaternion& b) {
  return a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
}

Quaternion blend(const Quaternion& a, double s, const Quaternion& b, double t) {
  const Quaternion q{s * a.w + t * b.w, s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z};
  const double scale = 1 / std::sqrt(inner(q, q));
  return {scale * q.w, scale * q.x, scale * q.y, scale * q.z};
}

}  // namespace

Placed placed_by(const Pose& pose, const char* of) {
  Placed placed;
  rotation_rows(pose.axis, pose.degrees, of, placed.rows);
  placed.translate = checked_vector(pose.translate, "pose.translate");
  if (pose.degrees != 0) {
    const auto [s, c] = scene::sine_cosine_degrees(pose.degrees / 2);
    const double3 n = times(s / length(pose.axis), pose.axis);
    placed.rotation = {c, n.x, n.y, n.z};
  }
  return placed;
}

static Placed turned_by(const Quaternion& q) {
  Placed placed;
  placed.rotation = blend(q, 1, {0, 0, 0, 0}, 0);
  rows_of(placed.rotation, placed.rows);
  return placed;
}

Placed turn_from_to(const double3& from, const double3& to, const double3& side) {
  const double w = 1 + inner(from, to);
  if (w < 1e-12) return turned_by({0, side.x, side.y, side.z});
  const double3 v = outer(from, to);
  return turned_by({w, v.x, v.y, v.z});
}

Placed turn_of_edges(const double3* from, const double3* to) {
  // The matrix R = sum of to_k from_k^T, and its quaternion from the largest of four candidates.
  double r[3][3] = {};
  for (int k = 0; k < 3; ++k) {
    const double a[3] = {to[k].x, to[k].y, to[k].z}, b[3] = {from[k].x, from[k].y, from[k].z};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) r[i][j] += a[i] * b[j];
    }
  }
  const double trace = r[0][0] + r[1][1] + r[2][2];
  if (trace > 0) {
    return turned_by({1 + trace, r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]});
  }
  int i = r[1][1] > r[0][0] ? 1 : 0;
  if (r[2][2] > r[i][i]) i = 2;
  const int j = (i + 1) % 3, k = (i + 2) % 3;
  double q[3];
  q[i] = 1 + r[i][i] - r[j][j] - r[k][k];
  q[j] = r[j][i] + r[i][j];
  q[k] = r[k][i] + r[i][k];
  return turned_by({r[k][j] - r[j][k], q[0], q[1], q[2]});
}

Placed after(const Placed& then, const Placed& first) {
  Placed both;
  for (int r = 0; r < 3; ++r) {
    const double3& t = then.rows[r];
    both.rows[r] =
        plus(plus(times(t.x, first.rows[0]), times(t.y, first.rows[1])), times(t.z, first.rows[2]));
  }
  both.translate = to_world(then, first.translate);
  const Quaternion &a = then.rotation, &b = first.rotation;
  both.rotation = {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
  return both;
}

Placed continued(const Placed& from, const Placed& to) {
  const auto [w, x, y, z] = from.rotation;
  Placed back;
  back.rotation = {w, -x, -y, -z};
  rows_of(back.rotation, back.rows);
  const Placed turn = after(to, back);  // the translation has no meaning
  Placed on = to;
  on.rotation = blend(after(turn, to).rotation, 1, {0, 0, 0, 0}, 0);
  rows_of(on.rotation, on.rows);
  on.translate = plus(to.translate, minus(to.translate, from.translate));
  return on;
}

double3 rotate(const double3* rows, const double3& v) {
  return {inner(rows[0], v), inner(rows[1], v), inner(rows[2], v)};
}

double3 to_world(const Placed& placed, const double3& described) {
  return plus(rotate(placed.rows, described), placed.translate);
}

bool same_rotation(const Placed& a, const Placed& b) {
  return same(a.rows[0], b.rows[0]) && same(a.rows[1], b.rows[1]) && same(a.rows[2], b.rows[2]);
}
bool same_place(const Placed& a, const Placed& b) {
  return same_rotation(a, b) && same(a.translate, b.translate);
}

void turn_between(const Placed& begin, const Placed& end, double fraction, double3* rows) {
  double3 now[3];
  if (fraction < 1) {
    const double shorter = inner(begin.rotation, end.rotation) < 0 ? -1 : 1;
    rows_of(blend(begin.rotation, 1 - fraction, end.rotation, shorter * fraction), now);
  } else {
    for (int r = 0; r < 3; ++r) now[r] = end.rows[r];
  }
  // now * transpose(begin)
  for (int r = 0; r < 3; ++r) rows[r] = rotate(begin.rows, now[r]);
}

}  // namespace weft::api
