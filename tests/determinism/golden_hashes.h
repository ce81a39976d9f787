// The hash of every scene of scenes.h after a quarter of a second. Every build gives these numbers:
// g++ and clang++, Release and Debug. They change only when the arithmetic of a step does, on
// purpose: then `weft_tests_determinism --gtest_filter='Golden*'` prints the new table.
#pragma once

#include "determinism/scenes.h"

namespace weft_tests {

struct GoldenHash {
  Scene scene;
  Variant variant;
  uint64_t hash;
};

/// Of the input of the mesh scene.
inline constexpr uint64_t golden_input = 0x4d5fe493d0e32771;

inline constexpr GoldenHash golden_hashes[] = {
    {Scene::grids, {weft::Precision::float32, weft::Form::summed}, 0x98ad8b09e4986b74},
    {Scene::grids, {weft::Precision::float32, weft::Form::position}, 0xd9828dcb266c38fc},
    {Scene::grids, {weft::Precision::float64, weft::Form::summed}, 0x1ab306b253ef15bf},
    {Scene::grids, {weft::Precision::float64, weft::Form::position}, 0x1ae241eb97bbe739},
    {Scene::mesh, {weft::Precision::float32, weft::Form::summed}, 0xf3cfac9ea9d5556d},
    {Scene::mesh, {weft::Precision::float32, weft::Form::position}, 0xb0227c0a4755a07a},
    {Scene::mesh, {weft::Precision::float64, weft::Form::summed}, 0xa3ca5d95223b7826},
    {Scene::mesh, {weft::Precision::float64, weft::Form::position}, 0x6b3bada37b66560a},
    {Scene::network, {weft::Precision::float32, weft::Form::summed}, 0xc5d515cfcbad635c},
    {Scene::network, {weft::Precision::float32, weft::Form::position}, 0x94814fb2441dc203},
    {Scene::network, {weft::Precision::float64, weft::Form::summed}, 0x656efe5cb4754e92},
    {Scene::network, {weft::Precision::float64, weft::Form::position}, 0x943fe38352e7d8b7},
    {Scene::mixed, {weft::Precision::float32, weft::Form::summed}, 0x015c932c7e26f808},
    {Scene::mixed, {weft::Precision::float32, weft::Form::position}, 0xd2aa357e9c8b27df},
    {Scene::mixed, {weft::Precision::float64, weft::Form::summed}, 0x6e96493dc4b6241c},
    {Scene::mixed, {weft::Precision::float64, weft::Form::position}, 0xc51b8c334419c607},
};

}  // namespace weft_tests
