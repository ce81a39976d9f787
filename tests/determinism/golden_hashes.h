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
    {Scene::grids, {weft::Precision::float32, weft::Form::summed}, 0x36709488e5edd7a8},
    {Scene::grids, {weft::Precision::float32, weft::Form::position}, 0x286be6b21ccfc7c2},
    {Scene::grids, {weft::Precision::float64, weft::Form::summed}, 0xb10401c77520c76b},
    {Scene::grids, {weft::Precision::float64, weft::Form::position}, 0xd71a7e129d64c795},
    {Scene::mesh, {weft::Precision::float32, weft::Form::summed}, 0x41cea6aca5908963},
    {Scene::mesh, {weft::Precision::float32, weft::Form::position}, 0x85c203796d52522d},
    {Scene::mesh, {weft::Precision::float64, weft::Form::summed}, 0x951741850b7886c9},
    {Scene::mesh, {weft::Precision::float64, weft::Form::position}, 0xf54ebab12abf7b31},
    {Scene::network, {weft::Precision::float32, weft::Form::summed}, 0xe094c1f8ea9ca583},
    {Scene::network, {weft::Precision::float32, weft::Form::position}, 0x9093fdf12aa8dcce},
    {Scene::network, {weft::Precision::float64, weft::Form::summed}, 0x9164d17f896fed87},
    {Scene::network, {weft::Precision::float64, weft::Form::position}, 0x8913dc9f51fa8c8f},
    {Scene::mixed, {weft::Precision::float32, weft::Form::summed}, 0xc11bf8e96f3ac9e1},
    {Scene::mixed, {weft::Precision::float32, weft::Form::position}, 0xed5635ce80acb77d},
    {Scene::mixed, {weft::Precision::float64, weft::Form::summed}, 0xa13acac31d98e50e},
    {Scene::mixed, {weft::Precision::float64, weft::Form::position}, 0x6f66dbea42cb3225},
};

}  // namespace weft_tests
