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
    {Scene::grids, {weft::Precision::float32, weft::Form::summed}, 0xb9af0b6051f70c66},
    {Scene::grids, {weft::Precision::float32, weft::Form::position}, 0xe885c0ba6b04cd43},
    {Scene::grids, {weft::Precision::float64, weft::Form::summed}, 0xccf96513d746cfeb},
    {Scene::grids, {weft::Precision::float64, weft::Form::position}, 0xff85a8427b1a5bad},
    {Scene::mesh, {weft::Precision::float32, weft::Form::summed}, 0x07ab312ef3e79953},
    {Scene::mesh, {weft::Precision::float32, weft::Form::position}, 0x3b6e269534495085},
    {Scene::mesh, {weft::Precision::float64, weft::Form::summed}, 0x1eef285e70484131},
    {Scene::mesh, {weft::Precision::float64, weft::Form::position}, 0xf81ee5d24ddb03c6},
    {Scene::network, {weft::Precision::float32, weft::Form::summed}, 0x40a9dd36eaa8f748},
    {Scene::network, {weft::Precision::float32, weft::Form::position}, 0xd939248da8d3ac26},
    {Scene::network, {weft::Precision::float64, weft::Form::summed}, 0x254268e88a565744},
    {Scene::network, {weft::Precision::float64, weft::Form::position}, 0xb110b2e86e533335},
    {Scene::mixed, {weft::Precision::float32, weft::Form::summed}, 0x9a904ed3749abdb6},
    {Scene::mixed, {weft::Precision::float32, weft::Form::position}, 0xc368bf0c2832acf6},
    {Scene::mixed, {weft::Precision::float64, weft::Form::summed}, 0x0158f3fdf8db5ae5},
    {Scene::mixed, {weft::Precision::float64, weft::Form::position}, 0x0dfbce665f4391bb},
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
    {"wind", {0xe4cbb1fdaa83d86f, 0xc49e7bb959df5539, 0xa4e7eb76f9713d27, 0x981f3d14ed296f96}},
    {"xpbd", {0x24a1838387b459ee, 0x24a1838387b459ee, 0x9a2397690633cf1f, 0x9a2397690633cf1f}},
    {"xpbd_ladder",
     {0x1a482224366b7524, 0x1a482224366b7524, 0xae2bebd0a55f4e55, 0xae2bebd0a55f4e55}},
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
     {0xa74d2cf3ac974a5f, 0x990353fdcb997449, 0xa8daa7b31ffd8bfe, 0x40b6fc9de9e5b34b}},
    {"sphere", {0xd826645028999e1d, 0x266b847618f08f51, 0x14d51e3b938bdf87, 0xcb008e53ab302155}},
    {"sphere_rough",
     {0x14580e2d9800dd88, 0x8433911fdf0d3fc6, 0x0a76b0a1d62b5f7d, 0x8e9793f4bac44c7c}},
    {"sphere_moving",
     {0x8f34b3cd4a6a4cf7, 0x2db1502292dc7e51, 0x43e3eb7e3aa41337, 0xf0304d3573032d14}},
    {"sphere_turning",
     {0x523bd3477b99058e, 0x12387d87c8c01a3e, 0x19d77c843db3210d, 0x36cf4b169615bdfc}},
    {"capsule", {0x1bf8bb6fca2aca41, 0x7d018ab4d32e248a, 0xdc798637c3dcb80a, 0x09d503e54f8f85eb}},
    {"capsule_rough",
     {0xea09c9e295210db0, 0x9f272016243e27ae, 0x53acbb99c345cfbf, 0xdb5c5edf6530faed}},
    {"capsule_moving",
     {0x9899092312464267, 0xa6c850573caa4a9c, 0x1a5e57a6c64625b0, 0x00994925f7f8408c}},
    {"capsule_turning",
     {0x2673f37ce01f0824, 0xa8b86ac16d2ac912, 0x7ce9add8a8e2bd3f, 0xfc428409159ed4c6}},
    {"cylinder", {0x58d922244ae4efc2, 0x4bca6a4a102b7d27, 0x8ba0d0eb9e29e95e, 0x3253ab90d709e43f}},
    {"cylinder_rough",
     {0x67d9ff394deb1f14, 0xaca61c2ccfc39b15, 0xd280351f43db1460, 0x20fc4211902917e5}},
    {"cylinder_moving",
     {0xe0041bc6789a7cb2, 0xa0ed0409bcd653f4, 0x9cf2bfd428be73b9, 0x71fc80b0015fe474}},
    {"cylinder_turning",
     {0xf6018e10063aee75, 0x8773430ca61f48e1, 0xf1831fe7857c54d5, 0x9c82d4af95c524b6}},
    {"box", {0xdd40a8d31aaf6a1d, 0x79659848e912966d, 0xc7d005d01bbd536b, 0x7c02fdca928e83e8}},
    {"box_rough", {0xb3e690e31f7dacc2, 0xfcd033770158c95d, 0xfd3e1f093820234b, 0x7c1ef03362521ba8}},
    {"box_moving",
     {0x164cd0541b33f43d, 0x1864db9db63541cc, 0x8f8661f4bd6908b7, 0x0a48913bb19d5594}},
    {"box_turning",
     {0x5b7e89c26f2553e9, 0xd0b2fed9a9f49b78, 0x35649e545379297f, 0x95c8b03bb0439457}},
    {"sphere_and_plane",
     {0xd826645028999e1d, 0x266b847618f08f51, 0x14d51e3b938bdf87, 0xcb008e53ab302155}},
    {"many_spheres",
     {0x67d92f3e7c717862, 0x400ac3963d0f2e98, 0x44f65a7a076327c1, 0xbc76cf06052f4b40}},
    {"all_shapes_rough",
     {0xc2ab9ad252258412, 0x16817e442c49b295, 0x71123a57075731b7, 0xc025b7aadb076357}},
    {"all_shapes_moving",
     {0x2e8b91cff3661afb, 0xa3ea39ec10e37f0c, 0x39a4b113114d016f, 0x424cb511b181386c}},
    {"all_shapes_turning",
     {0xb32c084943075ecd, 0xab8a4b14d0e986d9, 0x5c5865b977158b11, 0x5ed89b0ef0a981d9}},
    {"all_shapes_fast",
     {0x8356369f8f621047, 0xfa188efad3202233, 0xec4165389b4c5bc6, 0x4ea2181b4254c133}},
    {"both_meshes_rough",
     {0x22993c1fba94678d, 0xe098effdaaa4afa0, 0xa435d42f59172590, 0x49eaae31183e33a1}},
    {"both_meshes_moving",
     {0x207ae77cc67564fb, 0x79e9d0e7073b0b98, 0xdd47fca936d67d8f, 0x23965f735533d4f1}},
    {"both_meshes_turning",
     {0xdfda7e1b3c2a5cee, 0x6eb160ec4e52cb3d, 0x9fc3cdfe9f156cd6, 0xfe23df5ff46b84bc}},
    {"open_mesh", {0x22a77eac3627c49e, 0x9808a37659e091f1, 0xe9035938317c0b41, 0xdd9155abc6d92a2a}},
    {"open_mesh_rough",
     {0x49fc67e49ed4a773, 0x579218fd207dddfe, 0x79f0c53875d06364, 0x3042ff525d949e8a}},
    {"open_mesh_moving",
     {0xcae3bab9c0271f21, 0x818ca12906e838b3, 0x9f0d278b3d20d8c3, 0x8e9140a17230b536}},
    {"open_mesh_turning",
     {0x25a68d2e62367387, 0xf72a7cb6ff990610, 0xf71745447d930505, 0x806123900ab23906}},
    {"closed_mesh",
     {0xe367efff89cccdca, 0x9768b5f8d384e79d, 0x418b108e3d124f02, 0x5b50a7f984642350}},
    {"closed_mesh_rough",
     {0xc57d4fd8e90c4686, 0x36891dc0edbc188f, 0xcbf922c4ce44dbaa, 0x98bda5a3c39a51c9}},
    {"closed_mesh_moving",
     {0xb11808ecce64ef1a, 0x3744e7bdac03ee73, 0x087cd179acbf6199, 0xe31996bdd60ab865}},
    {"closed_mesh_turning",
     {0xa821aa1cbb433dc4, 0xc3677d0208d34a4e, 0x7b6a0ee9013ae530, 0xb76fbd34a3f778b6}},
    {"tethers", {0x46fd4bab57d3062c, 0x414bbe941f354ea6, 0x81af43fc2aad8849, 0x51787cdf0a150524}},
    {"soft_tethers",
     {0x7c5f73e8bcd845dc, 0x91e71b701a0e90f9, 0xdc892848d5d5db8c, 0x9cd8e0bf2432d4cc}},
    {"collider_layers",
     {0xd826645028999e1d, 0x266b847618f08f51, 0x14d51e3b938bdf87, 0xcb008e53ab302155}},
    {"self_collision",
     {0x9a37129ce8ffabf9, 0x803d48491d8054ed, 0xfcdd13ecb9d6c5a3, 0xceb2d7e7b8ffaac4}},
    {"staggered_grids",
     {0x9a37129ce8ffabf9, 0x803d48491d8054ed, 0xfcdd13ecb9d6c5a3, 0xceb2d7e7b8ffaac4}},
};

}  // namespace weft_tests
