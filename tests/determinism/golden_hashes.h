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
    {Scene::grids, {weft::Precision::float32, weft::Form::summed}, 0xd2497d519fc27554},
    {Scene::grids, {weft::Precision::float32, weft::Form::position}, 0xb2e003a5906a335c},
    {Scene::grids, {weft::Precision::float64, weft::Form::summed}, 0xa164818cc42af0a1},
    {Scene::grids, {weft::Precision::float64, weft::Form::position}, 0x145c07af1f4dbc03},
    {Scene::mesh, {weft::Precision::float32, weft::Form::summed}, 0x5069a281ca078a74},
    {Scene::mesh, {weft::Precision::float32, weft::Form::position}, 0x8549135f10b46a9b},
    {Scene::mesh, {weft::Precision::float64, weft::Form::summed}, 0x06b860f4fb690252},
    {Scene::mesh, {weft::Precision::float64, weft::Form::position}, 0x09e032894b5090ac},
    {Scene::network, {weft::Precision::float32, weft::Form::summed}, 0x350bc30a7569f257},
    {Scene::network, {weft::Precision::float32, weft::Form::position}, 0x164142d2cf88d828},
    {Scene::network, {weft::Precision::float64, weft::Form::summed}, 0xb14fea1ecfcd64cc},
    {Scene::network, {weft::Precision::float64, weft::Form::position}, 0x269873041e67ede5},
    {Scene::mixed, {weft::Precision::float32, weft::Form::summed}, 0x71aef02a86814372},
    {Scene::mixed, {weft::Precision::float32, weft::Form::position}, 0x427cdbbf1cc8316a},
    {Scene::mixed, {weft::Precision::float64, weft::Form::summed}, 0xc25fc795b81b70cb},
    {Scene::mixed, {weft::Precision::float64, weft::Form::position}, 0x1bfd401c240c14ee},
};

}  // namespace weft_tests
