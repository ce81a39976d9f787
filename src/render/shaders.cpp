#include "render/shaders.h"

namespace weft::render {

// The shadow is looked up once per vertex: most triangles are smaller than a pixel.
const char* const cloth_vertices = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 weave;
layout(location = 3) in vec3 weave_normal;
out vec3 at, facing, weave_at, weave_facing;
out float open;
void main() {
  at = position;
  facing = normal;
  weave_at = weave;
  weave_facing = weave_normal;
  open = lit(position, dot(normal, light) > 0.0 ? normal : -normal, 0, 0.0);
  gl_Position = before(position);
}
)";

const char* const solid_vertices = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 camera;
uniform vec3 moved;
out vec3 at, facing;
void main() {
  at = position + moved;
  facing = normal;
  gl_Position = camera * vec4(at, 1.0);
  gl_ClipDistance[0] = above_ground(at);
}
)";

const char* const bar_vertices = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 4) in vec3 a;
layout(location = 5) in vec3 b;
layout(location = 6) in float radius;
out vec3 at, facing;
void main() {
  vec3 along = b - a;
  float reach = length(along);
  vec3 w = reach > 0.0 ? along / reach : vec3(0.0, 0.0, 1.0);
  vec3 u = normalize(cross(abs(w.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0), w));
  facing = normal.x * u + normal.y * cross(w, u) + normal.z * w;
  at = (position.z > 0.0 ? b : a) + radius * facing;
  gl_Position = before(at);
  gl_ClipDistance[0] = above_ground(at);
}
)";

const char* const ground_vertices = R"(
uniform mat4 camera;
uniform vec3 middle, across, normal;
out vec3 at;
out vec2 away;
void main() {
  away = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  at = middle + away.x * across + away.y * cross(normal, across);
  gl_Position = camera * vec4(at, 1.0);
}
)";

const char* const screen_vertices = R"(
out vec2 across;
void main() {
  across = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  gl_Position = vec4(across * 2.0 - 1.0, 0.0, 1.0);
}
)";

// What casts a shadow is cut off there: nothing below the ground darkens it.
const char* const ground_functions = R"(
uniform vec3 ground, ground_normal;
float above_ground(vec3 p) { return dot(p - ground, ground_normal); }
)";

// Where a point is in the picture; it hides what is up to `lift` before it, as if it were there.
const char* const depth_functions = R"(
uniform mat4 camera;
uniform vec3 eye;
uniform float lift;
vec4 before(vec3 p) {
  vec4 at = camera * vec4(p, 1.0);
  float part = min(lift / (distance(p, eye) + 1e-30), 0.5);
  vec4 nearer = camera * vec4(mix(p, eye, part), 1.0);
  return vec4(at.xy, nearer.z / nearer.w * at.w, at.w);
}
)";

const char* const no_fragments = R"(
void main() {}
)";

// How much of the light reaches a point: the mean of looks at the shadow map around it, of
// (2 reach + 1)^2 that are `apart` texels from each other; all where the map ends.
const char* const shadow_functions = R"(
uniform vec3 light;
uniform mat4 shadow;
uniform sampler2DShadow depth;
uniform float texel;

float lit(vec3 p, vec3 n, int reach, float apart) {
  vec4 q = shadow * vec4(p + n * 2.0 * texel, 1.0);
  vec3 s = q.xyz * 0.5 + 0.5;
  float edge = max(abs(q.x), abs(q.y)), sum = 0.0;
  if (edge > 1.0) return 1.0;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      vec2 tap = vec2(x, y) * apart / vec2(textureSize(depth, 0));
      sum += texture(depth, vec3(s.xy + tap, s.z - 0.0008));
    }
  }
  float mean = sum / float((2 * reach + 1) * (2 * reach + 1));
  return mix(mean, 1.0, smoothstep(0.95, 1.0, edge));
}
)";

// Light from one side and from all sides, more of it from above. `wrap` lets it reach round an edge
// as it does through thin cloth; `open` is what the shadow map says.
const char* const light_functions = R"(
uniform vec3 eye, up;

vec3 shade(vec3 colour, vec3 p, vec3 n, float open, float wrap, float sheen) {
  vec3 v = normalize(eye - p);
  float lambert = max((dot(n, light) + wrap) / (1.0 + wrap), 0.0);
  float direct = lambert * open;
  float above = 0.5 + 0.5 * dot(n, up);
  vec3 ambient = mix(vec3(0.20, 0.19, 0.19), vec3(0.42, 0.45, 0.50), above);
  float rim = pow(1.0 - abs(dot(n, v)), 3.0);
  vec3 warm = vec3(1.0, 0.96, 0.90) * 0.78;
  return colour * (ambient + warm * direct) + sheen * rim * (0.35 + 0.65 * direct) * colour;
}

vec4 encoded(vec3 linear, float alpha) {
  return vec4(pow(clamp(linear, 0.0, 1.0), vec3(1.0 / 2.2)), alpha);
}
)";

const char* const cloth_fragments = R"(
in vec3 at, facing, weave_at, weave_facing;
in float open;
uniform vec3 ground_colour, stripe_colour, line_colour;
uniform float stripes;
out vec4 pixel;

// Bands across one direction: 1 in a broad band, and a narrow line between two of them.
vec2 bands(float x) {
  float soft = fwidth(x) + 1e-6;
  float f = abs(fract(x) - 0.5);
  float broad = smoothstep(0.27 - soft, 0.27 + soft, f);
  float narrow = 1.0 - smoothstep(0.030 - soft, 0.030 + soft, abs(f - 0.08));
  return vec2(broad, narrow);
}

vec3 dyed(vec2 b) {
  return mix(mix(ground_colour, stripe_colour, b.x), line_colour, b.y);
}

// A 2/2 twill: over two threads, under two, one further in each row. Too fine to be seen, it fades
// to the mean of both threads.
vec3 woven(vec2 uv) {
  vec3 warp = dyed(bands(uv.x * stripes)), weft = dyed(bands(uv.y * stripes));
  vec2 t = uv * stripes * 24.0;
  vec2 wide = fwidth(t);
  float fine = 1.0 - smoothstep(0.2, 0.6, max(wide.x, wide.y));
  float over = step(mod(floor(t.x) + floor(t.y), 4.0), 1.5);
  vec2 bulge = 1.0 - 2.2 * (fract(t) - 0.5) * (fract(t) - 0.5);
  vec3 thread = over > 0.5 ? warp * bulge.x : weft * bulge.y * 0.88;
  return mix(0.46 * (warp + weft), thread, fine);
}

void main() {
  vec3 n = normalize(facing + vec3(0.0, 0.0, 1e-12));
  if (!gl_FrontFacing) n = -n;
  vec3 w = pow(abs(weave_facing), vec3(6.0));
  w /= w.x + w.y + w.z + 1e-12;
  vec3 colour = w.z * woven(weave_at.xy);
  if (max(w.x, w.y) > 0.0) colour += w.x * woven(weave_at.yz) + w.y * woven(weave_at.zx);
  if (!gl_FrontFacing) colour *= 0.82;
  pixel = encoded(shade(colour, at, n, open, 0.25, 0.22), 1.0);
}
)";

const char* const solid_fragments = R"(
in vec3 at, facing;
uniform vec3 colour;
out vec4 pixel;
void main() {
  vec3 n = normalize(facing + vec3(0.0, 0.0, 1e-12));
  vec3 v = normalize(eye - at);
  if (dot(n, v) < 0.0 && !gl_FrontFacing) n = -n;
  float open = lit(at, n, 1, 1.7);
  float gloss = pow(max(dot(n, normalize(light + v)), 0.0), 40.0) * 0.12;
  pixel = encoded(shade(colour, at, n, open, 0.1, 0.05) + gloss * open, 1.0);
}
)";

const char* const ground_fragments = R"(
in vec3 at;
in vec2 away;
uniform vec3 normal;
out vec4 pixel;
void main() {
  vec3 colour = vec3(0.80, 0.79, 0.77) * (0.35 + 0.71 * lit(at, normal, 2, 3.5));
  float fade = 1.0 - smoothstep(0.12, 1.0, length(away));
  pixel = encoded(colour, fade * fade);
}
)";

const char* const sky_fragments = R"(
in vec2 across;
out vec4 pixel;
void main() {
  vec3 low = vec3(0.925, 0.925, 0.920), high = vec3(0.770, 0.815, 0.865);
  pixel = vec4(mix(low, high, smoothstep(0.25, 1.0, across.y)), 1.0);
}
)";

}  // namespace weft::render
