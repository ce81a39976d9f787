// The shaders, GLSL 3.30, without the line that says so.
#pragma once

namespace weft::render {

// What goes before shaders that use it; light_functions use shadow_functions.
extern const char* const shadow_functions;
extern const char* const light_functions;
extern const char* const depth_functions;
extern const char* const ground_functions;

// Vertices. Slots: 0 position, 1 normal, 2 weave coordinates, 3 weave normal; of instances 4 and 5
// the ends of a bar, 6 its radius.
extern const char* const cloth_vertices;   ///< needs shadow_functions and depth_functions
extern const char* const solid_vertices;   ///< needs ground_functions
extern const char* const bar_vertices;     ///< instanced; needs depth_ and ground_functions
extern const char* const ground_vertices;  ///< a square of 2 triangles, no attributes
extern const char* const screen_vertices;  ///< a triangle that covers all, no attributes

// Fragments; the first three need shadow_functions and light_functions.
extern const char* const cloth_fragments;   ///< woven, two-sided
extern const char* const solid_fragments;   ///< one colour
extern const char* const ground_fragments;  ///< fading away from the middle
extern const char* const no_fragments;      ///< depth only
extern const char* const sky_fragments;

}  // namespace weft::render
