#include "api/records/collider_motion.h"

#include <algorithm>
#include <cmath>

#include "scene/trigonometry.h"

namespace weft::api {

namespace {

void rows_of(const Quaternion& q, double3* rows) {
  const auto [w, x, y, z] = q;
  rows[0] = {1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)};
  rows[1] = {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)};
  rows[2] = {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)};
}

/// The inner product.
double of_both(const Quaternion& a, const Quaternion& b) {
  return a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
}

Quaternion blend(const Quaternion& a, double s, const Quaternion& b, double t) {
  const Quaternion q{s * a.w + t * b.w, s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z};
  const double scale = 1 / std::sqrt(of_both(q, q));
  return {scale * q.w, scale * q.x, scale * q.y, scale * q.z};
}

/// First b, then a.
Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

/// From `begin` to `end`, by at most half a turn; rounding does not choose the way of half a turn.
Quaternion turn_of(const Placed& begin, const Placed& end) {
  const auto [w, x, y, z] = begin.rotation;
  const Quaternion q = product(end.rotation, {w, -x, -y, -z});
  return q.w < -1e-12 ? Quaternion{-q.w, -q.x, -q.y, -q.z} : q;
}

/// sin(t a) / sin(a) as a series in cos(a) - 1, for angles up to a right one: no function of the
/// mathematics library, so the same bits everywhere (Eberly 2011, A fast and accurate algorithm
/// for computing SLERP).
double sine_ratio(double t, double cosine_less_1) {
  double term = t, sum = t;
  for (int i = 1; i < 64 && std::fabs(term) > 1e-17; ++i) {
    const double n = i, below = 1 / (2 * n + 1);
    term *= (t * t / n - n) * below * cosine_less_1;
    sum += term;
  }
  return sum;
}

/// The first part, 0 to 1, of a turn by at most half a turn: uniform in the angle.
Quaternion part_of(const Quaternion& turn, double t) {
  // 1 - cos of the half angle, without cancellation.
  const double across2 = turn.x * turn.x + turn.y * turn.y + turn.z * turn.z;
  const double less_1 = -across2 / (1 + turn.w);
  return blend({1, 0, 0, 0}, sine_ratio(1 - t, less_1), turn, sine_ratio(t, less_1));
}

/// Translation of a rigid motion's screw when it has turned by `now` of `all`; `by`: at its end.
double3 screwed(const Quaternion& all, const Quaternion& now, double t, const double3& by) {
  const double s2 = all.x * all.x + all.y * all.y + all.z * all.z;
  // About so small an angle a screw is a straight line, to all digits.
  if (s2 < 1e-15) return times(t, by);
  const double s = std::sqrt(s2), c = all.w;
  const double3 k{all.x / s, all.y / s, all.z / s};
  const double s_now = now.x * k.x + now.y * k.y + now.z * k.z, c_now = now.w;
  const double3 along = times(inner(k, by), k), across = minus(by, along);
  // c - R(t) c for the centre c = (across + cot(angle/2) k x across) / 2 of the whole turn.
  const double part = s_now / s;
  const double a = part * (c_now * c + s_now * s), b = part * (s_now * c - c_now * s);
  return plus(times(t, along), plus(times(a, across), times(b, outer(k, across))));
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
  if (w < 1e-12) {  // half a turn about `side` gives -from, which lacks next to nothing of `to`
    const double3 rest = outer(to, from);
    return turned_by(
        product({1 - inner(from, to), rest.x, rest.y, rest.z}, {0, side.x, side.y, side.z}));
  }
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
  both.rotation = product(then.rotation, first.rotation);
  both.endless = first.endless;
  return both;
}

Placed turned_further(const Placed& turn, const Placed& from) {
  Placed both = turned_by(product(turn.rotation, from.rotation));
  both.translate = from.translate;
  both.endless = from.endless;
  return both;
}

Placed continued(const Placed& from, const Placed& to) {
  if (same_rotation(from, to)) {  // to the bit: what has not turned has no room for a turn
    Placed on = to;
    on.translate = plus(to.translate, minus(to.translate, from.translate));
    return on;
  }
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

Placed between(const Placed& from, const Placed& to, double fraction) {
  if (fraction <= 0) return from;
  if (fraction >= 1) return to;
  Placed now = from;
  const double3 by = minus(to.translate, from.translate);
  double3 gone = times(fraction, by);
  if (!same_rotation(from, to)) {
    const Quaternion all = turn_of(from, to), part = part_of(all, fraction);
    now.rotation = blend(product(part, from.rotation), 1, {0, 0, 0, 0}, 0);
    rows_of(now.rotation, now.rows);
    if (from.endless) gone = screwed(all, part, fraction, by);
  }
  now.translate = plus(from.translate, gone);
  return now;
}

double half_turn_cosine(const Placed& begin, const Placed& end) {
  return std::min(1.0, std::fabs(of_both(begin.rotation, end.rotation)));
}

TurnInParts::TurnInParts(const Placed& begin, const Placed& end, int parts) : left_(parts) {
  const Quaternion q = part_of(turn_of(begin, end), 1.0 / parts);
  const double s2 = q.x * q.x + q.y * q.y + q.z * q.z, s = std::sqrt(s2);
  const double3 k = s > 0 ? times(1 / s, {q.x, q.y, q.z}) : double3{0, 0, 1};
  part_cos_ = 1 - 2 * s2;
  part_sin_ = 2 * s * q.w;
  const double axis[3] = {k.x, k.y, k.z};
  const double beside[9] = {0, -k.z, k.y, k.z, 0, -k.x, -k.y, k.x, 0};
  for (int r = 0; r < 3; ++r) {
    const double3 last = rotate(begin.rows, end.rows[r]);  // end * transpose(begin)
    const double lasts[3] = {last.x, last.y, last.z};
    for (int c = 0; c < 3; ++c) {
      const int i = 3 * r + c;
      along_[i] = axis[r] * axis[c];
      across_[i] = (r == c ? 1 : 0) - along_[i];
      beside_[i] = beside[i];
      last_[i] = lasts[c];
    }
  }
}

}  // namespace weft::api
