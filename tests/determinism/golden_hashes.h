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
    {Scene::grids, {weft::Precision::float32, weft::Form::summed}, 0xf9e4ff8a9755b9d5},
    {Scene::grids, {weft::Precision::float32, weft::Form::position}, 0x971243c6ca6f9367},
    {Scene::grids, {weft::Precision::float64, weft::Form::summed}, 0x44d8f6ae1921b723},
    {Scene::grids, {weft::Precision::float64, weft::Form::position}, 0xb86558a88d99abb8},
    {Scene::mesh, {weft::Precision::float32, weft::Form::summed}, 0xc250ac272e423ca5},
    {Scene::mesh, {weft::Precision::float32, weft::Form::position}, 0xf455bd01971b1bc4},
    {Scene::mesh, {weft::Precision::float64, weft::Form::summed}, 0xcba596abcd36684a},
    {Scene::mesh, {weft::Precision::float64, weft::Form::position}, 0x5c7588ed231b14d7},
    {Scene::network, {weft::Precision::float32, weft::Form::summed}, 0x9f39ec1e106b0905},
    {Scene::network, {weft::Precision::float32, weft::Form::position}, 0x76af05cb59807bf4},
    {Scene::network, {weft::Precision::float64, weft::Form::summed}, 0xdc52b4fb1f86aa9e},
    {Scene::network, {weft::Precision::float64, weft::Form::position}, 0xaf297c60eaa7f812},
    {Scene::mixed, {weft::Precision::float32, weft::Form::summed}, 0x106be6af41c0bf84},
    {Scene::mixed, {weft::Precision::float32, weft::Form::position}, 0x1d66ece58eff8af9},
    {Scene::mixed, {weft::Precision::float64, weft::Form::summed}, 0xbbcba7b6c6d4b4b6},
    {Scene::mixed, {weft::Precision::float64, weft::Form::position}, 0x3f3b74dfb9bb0e9b},
};

}  // namespace weft_tests
