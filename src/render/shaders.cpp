#include "render/shaders.h"

namespace weft::render {

// The shadow is looked up once per vertex: most triangles are smaller than a pixel.
const char* const cloth_vertices = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 weave;
layout(location = 3) in vec3 weave_normal;
uniform mat4 camera;
out vec3 at, facing, weave_at, weave_facing;
out float open;
void main() {
  at = position;
  facing = normal;
  weave_at = weave;
  weave_facing = weave_normal;
  open = lit(position, dot(normal, light) > 0.0 ? normal : -normal);
  gl_Position = camera * vec4(position, 1.0);
}
)";

const char* const caster_vertices = R"(
layout(location = 0) in vec3 position;
uniform mat4 camera;
void main() {
  gl_Position = camera * vec4(position, 1.0);
  gl_ClipDistance[0] = above_ground(position);
}
)";

const char* const solid_vertices = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 camera, model, turned;
out vec3 at, facing;
void main() {
  at = (model * vec4(position, 1.0)).xyz;
  facing = mat3(turned) * normal;
  gl_Position = camera * vec4(at, 1.0);
  gl_ClipDistance[0] = above_ground(at);
}
)";

const char* const capsule_vertices = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 end;
layout(location = 4) in vec3 a;
layout(location = 5) in vec3 b;
layout(location = 6) in float radius;
uniform mat4 camera;
out vec3 at, facing;
void main() {
  vec3 along = b - a;
  float reach = length(along);
  vec3 w = reach > 0.0 ? along / reach : vec3(0.0, 0.0, 1.0);
  vec3 u = normalize(cross(abs(w.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0), w));
  facing = position.x * u + position.y * cross(w, u) + position.z * w;
  at = mix(a, b, end.x) + radius * facing;
  gl_Position = camera * vec4(at, 1.0);
  gl_ClipDistance[0] = above_ground(at);
}
)";

const char* const ground_vertices = R"(
uniform mat4 camera, model;
out vec3 at;
out vec2 away;
void main() {
  away = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  at = (model * vec4(away, 0.0, 1.0)).xyz;
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

const char* const no_fragments = R"(
void main() {}
)";

// How much of the light reaches a point: the mean of nine looks at the shadow map around it; all
// where the map ends.
const char* const shadow_functions = R"(
uniform vec3 light;
uniform mat4 shadow;
uniform sampler2DShadow depth;
uniform float texel;

float lit(vec3 p, vec3 n) {
  vec4 q = shadow * vec4(p + n * 2.0 * texel, 1.0);
  vec3 s = q.xyz * 0.5 + 0.5;
  float sum = 0.0;
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) {
      vec2 tap = (vec2(x, y) - 1.0) * 1.7 / vec2(textureSize(depth, 0));
      sum += texture(depth, vec3(s.xy + tap, s.z - 0.0008));
    }
  }
  return mix(sum / 9.0, 1.0, smoothstep(0.985, 1.0, max(abs(q.x), abs(q.y))));
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
uniform float threads, stripes;
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
  vec2 t = uv * threads;
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
  float open = lit(at, n);
  float gloss = pow(max(dot(n, normalize(light + v)), 0.0), 40.0) * 0.12;
  pixel = encoded(shade(colour, at, n, open, 0.1, 0.05) + gloss * open, 1.0);
}
)";

const char* const ground_fragments = R"(
in vec3 at;
in vec2 away;
uniform sampler2D soft;
uniform vec3 normal;
out vec4 pixel;
void main() {
  vec4 q = shadow * vec4(at, 1.0);
  vec2 s = q.xy * 0.5 + 0.5;
  float inside = 1.0 - smoothstep(0.95, 1.0, max(abs(q.x), abs(q.y)));
  float covered = texture(soft, s).r * inside;
  float direct = 0.35 * mix(1.0, lit(at, normal), inside) + 0.65 * (1.0 - covered);
  float sky = 1.0 - 0.35 * covered;
  vec3 colour = vec3(0.80, 0.79, 0.77) * (0.44 * sky + 0.62 * direct);
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

// The first of two passes reads the depth map: covered where anything is nearer than its end.
const char* const blur_fragments = R"(
in vec2 across;
uniform sampler2DShadow depth;
uniform sampler2D half_done;
uniform vec3 step_by;
uniform int first;
out vec4 pixel;
void main() {
  float sum = 0.0, weights = 0.0;
  for (int i = -7; i <= 7; ++i) {
    float weight = exp(-float(i * i) / 18.0);
    vec2 tap = across + step_by.xy * float(i);
    float covered = first == 1 ? 1.0 - texture(depth, vec3(tap, 0.9999))
                               : texture(half_done, tap).r;
    sum += weight * covered;
    weights += weight;
  }
  pixel = vec4(sum / weights);
}
)";

}  // namespace weft::render
