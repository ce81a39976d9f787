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

/// Of the row of this name of samples/effects after 12 frames: float32 summed, float32 position,
/// float64 summed, float64 position. `weft_tests_determinism --gtest_filter='*EveryBuild*'` prints
/// lines that are missing or wrong.
struct EffectHashes {
  const char* effect;
  uint64_t hashes[4];
};
inline constexpr EffectHashes effect_hashes[] = {
    {"central_drag",
     {0xefb1fbd27f40c62f, 0x59c1c302b569f184, 0x5b635c41d931db3f, 0x9780efe27e05d611}},
    {"lagged_drag",
     {0xbff9cd8af2c9cbee, 0xf6b06d77333addfc, 0xa846d739dd1027ad, 0xff5ef00fb441ef18}},
    {"spring_damping",
     {0x72005903f7ddcf03, 0x3cdf01d9af7b3556, 0x19024372f946739d, 0x3f8860180f1d3fb4}},
    {"constant_forces",
     {0x619c0231ed84512d, 0x175c23196314d314, 0x2ab8ea9234b61263, 0x250a4eb3a94d2d80}},
    {"moving_pins",
     {0x7cd3df8163ebfc5a, 0x741b4478a07012ce, 0x2b0f8844c670ef1b, 0x45f29a305464de48}},
    {"led_pins", {0x64b66f1d97128c0b, 0xc68d97c35a0e423f, 0xdda323319a2604bc, 0xa58b9c3a779d7830}},
    {"sleep", {0xda7130e9006338ed, 0xadcaff1c79c8e786, 0xee118bad0ee2b741, 0x83f43c0eb10be8eb}},
    {"wind", {0x33bd28bc6050ff38, 0x510ff65bdf302962, 0xc84760570890bbc4, 0x07277767fc8a4298}},
    {"scatter_fixed64",
     {0x66200cfe4e1799e8, 0xb2a0eca68a73e137, 0xa37fab01bd6fe7ef, 0x455a428e27711cc4}},
    {"scatter_float16",
     {0xacbd95e4be1d0322, 0xf4f6c0171f8e89c6, 0xf817b565f980736a, 0x36eb6bd0dc908ee0}},
    {"scatter_float24",
     {0x46140134ca509efa, 0x2c02c210b53f092d, 0x17a88cd88c216ec8, 0x286e2a492dd865fc}},
    {"scatter_float24_all",
     {0x01027c7eb7185d13, 0x05afd341ecc191f2, 0xeed7b5d36f64957e, 0xc9a71235ef518b42}},
    {"scatter_fixed8",
     {0xe7a2b7e3cde2182f, 0x30186dffbe199a76, 0x171332b13a3d016c, 0xcf59d44891339718}},
    {"plane", {0x65bf26703ec46657, 0x7d378a287404a216, 0x77de4879c8f48b20, 0x6a28fecb9c0ef281}},
    {"plane_rough",
     {0x5a6704958ab0bac2, 0x9c614ae9040665a5, 0x6cd920476e182517, 0xf4f6d2a086227345}},
    {"plane_moving",
     {0x0339ba2e05d678f3, 0x1f214e3564d5d1af, 0x5626363c9a2e1420, 0x70947600c099fea5}},
    {"plane_turning",
     {0x06404f457bc28658, 0xf7449abf625aa005, 0x83cab4da07952e81, 0x3d3f074526561de1}},
    {"sphere", {0x2d8ae8ee803a39a4, 0x33af3b1efaee51ee, 0x90f45f6959de24fb, 0xa8885635a1f4f16f}},
    {"sphere_rough",
     {0x31a61005d641c389, 0xab6d9bb59b6ea8a5, 0xc20d323d76047732, 0x2e3dfc78635659ab}},
    {"sphere_moving",
     {0xdbe4e6642c30bb52, 0x3224084b91eceb49, 0x0ae3c42353889b37, 0x3dc5870acaf54945}},
    {"sphere_turning",
     {0x81b33901c23c9ae4, 0x3890ebc79dedadca, 0x0b16c46ff8ebe080, 0x2754b6101784b9bc}},
    {"capsule", {0xb61a562958a41cf9, 0xd431db8d95dbf5d4, 0x748e5f1f36b41241, 0x3c6c0e41b9ce79a8}},
    {"capsule_rough",
     {0x0bd56eb3934c03f8, 0x09319cb6cea25aef, 0x6639ba0d673b128a, 0x6a18a92cfaabbaa4}},
    {"capsule_moving",
     {0x95f22321297542bf, 0x4fd4780aa9f02cd4, 0xd8ae852744a5916d, 0x0d5773671b54d18f}},
    {"capsule_turning",
     {0x22c9488088f21e03, 0x9a1fd30b1e964203, 0xee31b909cfa2c869, 0x8b9cf78f7f1dcdf1}},
    {"cylinder", {0x155af2f1f5b0eb6e, 0xa8cb12d62e8cbcc9, 0x262d07b2008701a9, 0x18786c47225f06e9}},
    {"cylinder_rough",
     {0xb2157ab8c4eac5a5, 0x97349234b7a7ab15, 0xbfc008b608b623d4, 0x547281263924c012}},
    {"cylinder_moving",
     {0xb10e594c33c825d6, 0x5b8baa8bcf00f354, 0x9c3fb44b10f2b418, 0xe8e38253bab4511c}},
    {"cylinder_turning",
     {0x858b0665c32dfcd0, 0xef010af0e85e0b93, 0x57395a25d187479b, 0xaa5a5895dc8ae8f5}},
    {"box", {0x72294b8b9cd50565, 0x79659848e912966d, 0x460c611e632151ad, 0x7c02fdca928e83e8}},
    {"box_rough", {0xfc4b693636f8d396, 0x63f66d22c37536cd, 0x23d8d9e66b23f554, 0x448c85e3aa573d50}},
    {"box_moving",
     {0x416e5fa72c31a8f6, 0x249c7fc1efde2781, 0xb8b83ee4fc6a91c9, 0x9168929d2607d0f5}},
    {"box_turning",
     {0x136fcfc4ffad0b5c, 0x87385a570c33f362, 0x82745e1ae64b3ae9, 0xcdf865af36c6f792}},
    {"sphere_and_plane",
     {0x2d8ae8ee803a39a4, 0x33af3b1efaee51ee, 0x90f45f6959de24fb, 0xa8885635a1f4f16f}},
    {"many_spheres",
     {0x7ffbc8e98626094a, 0x077b1d4994ccdbb7, 0xdaac9f20a3e0c263, 0x18e383d7a2378ce0}},
    {"all_shapes_rough",
     {0x41cd0984de522620, 0xc9a1ac28a6b7d6ef, 0xe0b845fe4ca1a9b2, 0x22e650f96ef57807}},
    {"all_shapes_moving",
     {0x578f6645a81bc8c4, 0x533d2cfe5a377e51, 0xa6a7bd286f78e44e, 0xa2f05eae927302f5}},
    {"all_shapes_turning",
     {0x936255e962b76d64, 0xd0784b6543893544, 0x0dbac4c91fdb266e, 0x6017c40fc25d7fd7}},
    {"all_shapes_fast",
     {0x674d10b6659c70fd, 0xee93db4025c056d8, 0x50abf01592dc4c7a, 0x0fe917ca101a1afb}},
    {"both_meshes_rough",
     {0xacfd4721078e208d, 0x92a6f4478851f693, 0xbbd54a234a1c0ef0, 0xd15d558cf0b76b58}},
    {"both_meshes_moving",
     {0xbc6729f4fdf45d1b, 0x1b6ee2bbbbfc271e, 0x43049b57a60bc203, 0x5b795f40438cd98f}},
    {"both_meshes_turning",
     {0x7a8de9d855ca1050, 0x237790233864ca68, 0x7e0d0b2db7cfc712, 0xc54999784b529861}},
    {"open_mesh", {0xe8405df06dc90ec9, 0xc336cd5a8a78165b, 0x061aaf6779ae598f, 0x4a8593ae853adc51}},
    {"open_mesh_rough",
     {0x7ce7c89c17072d4d, 0x9e95d23da65a7ae5, 0x71d5360558b6b56b, 0x5fa3b5dbc341d012}},
    {"open_mesh_moving",
     {0xceb00a35e89087b5, 0x87e4ba0afad180cf, 0x2f9e612251b41456, 0x0f1a7f8a618ed930}},
    {"open_mesh_turning",
     {0x6dabb9af304a06b9, 0x3d4dc797fe388588, 0x776e0efcc89d3225, 0xdb72539c70d1d0c1}},
    {"closed_mesh",
     {0x0876ec7a624f085f, 0xee8ccaf500e88bcc, 0x4074f278bd208244, 0xf7b7b31f04dfe893}},
    {"closed_mesh_rough",
     {0x111dd96c22d68c2e, 0xdf0c6168cbc92d4c, 0x1695c4740745ed0a, 0x10cce39a9a0278a1}},
    {"closed_mesh_moving",
     {0x477db24c6f27c595, 0xa33f5eac4ea881d8, 0xf5164c9403523bc0, 0x9918351d444c2f22}},
    {"closed_mesh_turning",
     {0x2e6131e83702a65d, 0x1b2229173218ca04, 0x0ac4c4e449129c0f, 0x5f10e714d3baf0ee}},
    {"tethers", {0x46fd4bab57d3062c, 0x414bbe941f354ea6, 0x81af43fc2aad8849, 0x51787cdf0a150524}},
    {"soft_tethers",
     {0x7c5f73e8bcd845dc, 0x91e71b701a0e90f9, 0xdc892848d5d5db8c, 0x9cd8e0bf2432d4cc}},
};

}  // namespace weft_tests
