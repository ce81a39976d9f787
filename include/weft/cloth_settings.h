/* The plain numbers of a cloth: one struct for C and C++, which a cloth's description, its scene
 * and its record hold as it is. Each is finite and not negative; the default is 0, no effect,
 * unless said otherwise. C takes the defaults from weft_default_cloth(). */
#ifndef WEFT_CLOTH_SETTINGS_H
#define WEFT_CLOTH_SETTINGS_H

#include <stdint.h>

#ifdef __cplusplus
namespace weft {
inline namespace v0 {
/// Which velocity the drag force -c v uses.
enum class DragModel : uint8_t {
  central,  ///< (x_(n+1) - x_(n-1))/2dt: order 2, does not lower the stable step
  lagged    ///< (x_n - x_(n-1))/dt, Georgii and Westermann eq. (2): order 1, lowers it
};
}  // namespace v0
}  // namespace weft
typedef weft::DragModel weft_drag_model;
#else
typedef uint8_t weft_drag_model;
#endif
enum { WEFT_DRAG_CENTRAL, WEFT_DRAG_LAGGED };

typedef struct weft_cloth_settings {
  double drag; /**< N s/m per vertex */
  /** N s/m along each spring, with the velocity of the last substep. */
  double spring_damping;
  /** The cloth goes to sleep when for `sleep_time` seconds no particle was faster than
   * `sleep_speed` (m/s; 0: it never sleeps) at the end of any step, unless a motion leads one of
   * its pins. Asleep, its particles stand still and cost next to nothing. */
  double sleep_speed;
  double sleep_time; /**< s; default 0.5 */
  /** Above 0, each free vertex keeps within this many times its rest distance from the nearest pin
   * (the shortest path over edges) of where that pin is. Vertices that no pin reaches have no
   * tether: World::diagnostics. The paths are worked out when the cloth is made, and again when
   * pins are added or released (0.2 us per vertex); moving them costs nothing. */
  double tether_scale;
  double tether_compliance; /**< m/N; 0: hard, else as XPBD has it */
  /** m: nearer than this its particles touch, in a world with self-collision; 0: the world's
   * distance. Two cloths take the mean of theirs. */
  double collision_distance;
  weft_drag_model drag_model;
  uint8_t collides_itself; /**< 0 or 1, the default: particles of this cloth meet each other */
  uint8_t collides_others; /**< 0 or 1, the default: they meet those of other cloths */
  /** Default: all bits. A cloth and another, or a cloth and a collider, meet where both have a bit
   * in common. */
  uint32_t collision_layers;
} weft_cloth_settings;

#ifdef __cplusplus
namespace weft {
inline namespace v0 {
struct ClothSettings : weft_cloth_settings {
  constexpr ClothSettings() : weft_cloth_settings{} {
    sleep_time = 0.5;
    collides_itself = collides_others = 1;
    collision_layers = ~0u;
  }
};

/// The numbers by name, for whoever treats them all alike: checks, messages, an editor's sliders.
struct ClothNumber {
  const char* name;
  double weft_cloth_settings::*value;
};
inline constexpr ClothNumber cloth_numbers[] = {
    {"drag", &weft_cloth_settings::drag},
    {"spring_damping", &weft_cloth_settings::spring_damping},
    {"sleep_speed", &weft_cloth_settings::sleep_speed},
    {"sleep_time", &weft_cloth_settings::sleep_time},
    {"tether_scale", &weft_cloth_settings::tether_scale},
    {"tether_compliance", &weft_cloth_settings::tether_compliance},
    {"collision_distance", &weft_cloth_settings::collision_distance},
};
static_assert(sizeof cloth_numbers / sizeof *cloth_numbers * sizeof(double) + sizeof(double) ==
                  sizeof(ClothSettings),
              "a number is missing in the list above");
}  // namespace v0
}  // namespace weft
#endif

#endif
