// The shaders, GLSL 3.30, without the line that says so.
#pragma once

namespace weft::render {

// What goes before shaders that use it; the second uses the first.
extern const char* const shadow_functions;
extern const char* const light_functions;

// Vertices. Slots: 0 position, 1 normal, 2 weave coordinates, 3 weave normal; of instances 4 and 5
// the ends of a capsule, 6 its radius.
extern const char* const cloth_vertices;    ///< needs shadow_functions
extern const char* const caster_vertices;   ///< a cloth's depth only
extern const char* const solid_vertices;    ///< uniform `model`
extern const char* const capsule_vertices;  ///< instanced
extern const char* const ground_vertices;   ///< a square of 2 triangles, no attributes
extern const char* const screen_vertices;   ///< a triangle that covers all, no attributes

// Fragments; the first three need both functions.
extern const char* const cloth_fragments;   ///< woven, two-sided
extern const char* const solid_fragments;   ///< one colour
extern const char* const ground_fragments;  ///< with a soft shadow, fading away from the middle
extern const char* const ground_functions;  ///< for vertices of casters
extern const char* const no_fragments;      ///< depth only
extern const char* const sky_fragments;
extern const char* const blur_fragments;  ///< one direction of a Gaussian filter

}  // namespace weft::render
