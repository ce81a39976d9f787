// A game's loop: frames of uneven length, a hand that carries a flag, a ball that a player moves,
// and a vertex buffer that is written every frame. Prints what an engine would show.
#include "weft/weft.hpp"

#include <cmath>
#include <cstdio>
#include <vector>

namespace {

struct Vertex {  // as the renderer wants it
  float position[3];
  int8_t normal[4];
  float uv[2];  // written once, by the game
};

constexpr uint32_t rows = 24, columns = 36;

bool ok(weft::Status status, const char* what) {
  if (status == weft::Status::ok) return true;
  std::fprintf(stderr, "engine_loop: %s failed: %s\n", what, weft::to_string(status));
  return false;
}

void print(void*, weft::Severity, const char* text) { std::fprintf(stderr, "weft: %s\n", text); }

// A machine that hiccups: milliseconds per frame.
double frame_seconds(int frame) {
  const double usual[] = {0.0069, 0.0071, 0.0166, 0.0083, 0.0331};
  return frame == 90 ? 0.35 : usual[frame % 5];
}

}  // namespace

int main() {
  weft::ContextDesc context_desc;
  context_desc.log.message = print;
  auto context = weft::Context::create(context_desc);
  if (!context) return 1;

  weft::GridDesc grid;
  grid.rows = rows;
  grid.columns = columns;
  grid.width = 1.5;
  grid.material.mass.value = 0.15;
  auto fabric = context->cook(grid);
  weft::WorldDesc world_desc;
  world_desc.interpolate = true;  // frames lie between steps
  auto world = context->create_world(world_desc);
  if (!fabric || !world) return 1;

  std::vector<weft::Pin> pole;
  for (uint32_t r = 0; r < rows; ++r) pole.push_back({r * columns});
  weft::ClothDesc cloth_desc;
  cloth_desc.fabric = *fabric;
  cloth_desc.pins = pole;
  cloth_desc.drag = 1e-5;
  const auto flag = world->create_cloth(cloth_desc);
  weft::SphereDesc ball_desc;
  ball_desc.center = {0.8, 0.5, -0.6};
  ball_desc.radius = 0.2;
  const auto ball = world->create_sphere(ball_desc);
  weft::WindDesc wind;
  wind.velocity = {4, 0, 1};
  if (!flag || !ball || !ok(world->set_wind(wind), "the wind")) return 1;

  std::vector<Vertex> buffer(rows * columns);
  weft::OutputDesc output;
  output.layout.position = {weft::Format::f32x3, 0, sizeof(Vertex)};
  output.layout.normal = {weft::Format::snorm8x4, 12, sizeof(Vertex)};
  output.memory = buffer.data();
  output.bytes = buffer.size() * sizeof(Vertex);
  if (!world->bind_output(*flag, output)) return 1;

  double game_time = 0;
  uint32_t steps = 0;
  std::vector<uint32_t> held;
  std::vector<weft::double3> hand;
  for (const weft::Pin& pin : pole) held.push_back(pin.vertex);
  for (int frame = 0; frame < 120; ++frame) {
    const double dt = frame_seconds(frame);
    game_time += dt;

    // Inputs: where the animation has the pole, and the player the ball.
    hand.clear();
    for (uint32_t r = 0; r < rows; ++r) {
      hand.push_back({0, double(r) / (rows - 1), 0.1 * std::sin(3 * game_time)});
    }
    weft::Pose moved;
    moved.translate = {0, 0, 0.3 * std::sin(2 * game_time)};
    if (!ok(world->move_pins(*flag, held, weft::View<weft::double3>(hand)), "moving pins"))
      return 1;
    if (!ok(world->move_collider(*ball, moved), "moving the ball")) return 1;

    // Time: as many even steps as fit; the picture lies between the last two.
    const auto advance = world->advance(dt);
    if (!advance || !ok(world->write_outputs(advance->alpha), "the output")) return 1;
    steps += advance->steps;

    const weft::View<weft::Event> events = world->events();
    for (uint32_t e = 0; advance->steps > 0 && e < events.count; ++e) {
      std::printf("frame %d: %s\n", frame, events[e].text);
    }
    if (frame % 30 == 29) {
      const Vertex& corner = buffer.back();
      const auto bounds = world->bounds(*flag);
      std::printf("frame %3d  %6.3f s  %3u steps  corner (%.3f, %.3f, %.3f)  x up to %.3f m\n",
                  frame, game_time, steps, double(corner.position[0]), double(corner.position[1]),
                  double(corner.position[2]), bounds->high.x);
    }
  }
  std::printf("%.3f s dropped\n", world->stats().time_dropped);
  return 0;
}
