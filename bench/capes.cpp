#include "bench/capes.h"

#include <cmath>
#include <memory>
#include <string>

#include "bench/interleave.h"
#include "samples/effects/effect.h"
#include "weft/weft.hpp"

namespace weft::bench {

namespace {

using samples::check;
using samples::take;

constexpr uint32_t rows = 20, columns = 18, substeps = 32;
constexpr size_t capsules = 12;
constexpr double frame = 1.0 / 60;
constexpr int frames = 10;  ///< of a call

enum class Motion { none, moves, turns };

/// A damped sheet that hangs by its upper edge in wind, and the capsules of a body behind it.
class Cape {
 public:
  /// `gap`: m from the sheet to the capsules; `with`: none at all otherwise.
  Cape(bool with, Motion motion, double gap)
      : context_(take(Context::create(one_thread()))),
        world_(take(context_.create_world(world()))),
        motion_(motion),
        gap_(gap) {
    GridDesc grid;
    grid.rows = rows;
    grid.columns = columns;
    grid.material.stiffness = 200;
    grid.material.mass.value = 0.35;
    std::vector<Pin> pins;
    for (uint32_t c = 0; c < columns; ++c) pins.push_back({(rows - 1) * columns + c});
    ClothDesc cloth;
    cloth.fabric = take(context_.cook(grid));
    cloth.pins = pins;
    cloth.spring_damping = 0.01;
    check(world_.create_cloth(cloth).status());
    WindDesc wind;
    wind.velocity = {0, 0, 0.5};
    check(world_.set_wind(wind));
    if (with) set_ = take(world_.create_collider_set(place()));
    with_ = with;
    for (int i = 0; i < 60; ++i) advance();
  }

  void advance() {
    time_ += frame;
    if (with_ && motion_ != Motion::none) check(world_.move_collider_set(set_, place()));
    check(world_.step(frame));
  }

 private:
  static ContextDesc one_thread() {
    ContextDesc desc;
    desc.threads = 1;
    return desc;
  }
  static WorldDesc world() {
    WorldDesc desc;
    desc.substeps = substeps;
    return desc;
  }
  ColliderSetDesc place() {
    const double sway = motion_ == Motion::none ? 0 : 0.02 * std::sin(3 * time_);
    for (size_t i = 0; i < capsules; ++i) {
      const double angle = motion_ == Motion::turns ? 0.3 * std::sin(5 * time_ + double(i)) : 0;
      const double3 half{0.15 * std::cos(angle), 0.15 * std::sin(angle), 0};
      const double3 middle{0.5 + sway, 0.08 + 0.075 * double(i), gap_ + 0.05};
      limbs_[i].a = {middle.x - half.x, middle.y - half.y, middle.z};
      limbs_[i].b = {middle.x + half.x, middle.y + half.y, middle.z};
      limbs_[i].radius = 0.05;
    }
    ColliderSetDesc set;
    set.capsules = View<CapsuleDesc>(limbs_, capsules);
    return set;
  }

  Context context_;
  World world_;
  Motion motion_;
  double gap_, time_ = 0;
  bool with_ = false;
  CapsuleDesc limbs_[capsules];
  ColliderSetId set_;
};

}  // namespace

void append_capes(int rounds, std::ostream& progress, std::vector<Row>& out) {
  struct Line {
    const char* name;
    Motion motion;
    double gap;
  };
  constexpr Line lines[] = {{"cape of 20 x 18, 12 capsules out of reach", Motion::none, 3},
                            {"cape of 20 x 18, 12 moving capsules out of reach", Motion::moves, 3},
                            {"cape of 20 x 18, 12 turning capsules out of reach", Motion::turns, 3},
                            {"cape of 20 x 18 on 12 capsules", Motion::none, 0.01},
                            {"cape of 20 x 18 on 12 moving capsules", Motion::moves, 0.01},
                            {"cape of 20 x 18 on 12 turning capsules", Motion::turns, 0.01}};
  Interleaved runs("effects");

  const auto add = [&](const char* name, bool with, Motion motion, double gap) {
    auto cape = std::make_shared<Cape>(with, motion, gap);
    return runs.add({name, double(rows * columns * substeps * frames), [cape] {
                       for (int i = 0; i < frames; ++i) cape->advance();
                     }});
  };
  const size_t bare = add("cape alone", false, Motion::none, 0);
  for (const Line& l : lines) add(l.name, true, l.motion, l.gap);
  runs.run(rounds, progress);
  for (size_t i = 1; i <= std::size(lines); ++i) {
    runs.append_difference(runs.name(i), "ns", i, bare, out);
    runs.append_ratio(runs.name(i), i, bare, out);
  }
}

}  // namespace weft::bench
