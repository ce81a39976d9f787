// Frames as meshes and as point caches.
#pragma once

#include "frame_sink.h"

#include <memory>

namespace weft::tools {

struct MeshFormat {
  Precision precision;
  bool normals;
};

/// FOLDER/frame_000000.obj, ...
std::unique_ptr<FrameSink> make_obj_frames(const std::string& folder, MeshFormat);
/// FOLDER/frame_000000.ply, ...
std::unique_ptr<FrameSink> make_ply_frames(const std::string& folder, MeshFormat);

/// For each cloth FOLDER/NAME.pc2 and FOLDER/NAME.obj, the mesh at the start that it moves. What a
/// file name cannot hold is an underscore; a name that is taken is numbered.
std::unique_ptr<FrameSink> make_point_caches(const std::string& folder, const io::Surface& start,
                                             Precision);

}  // namespace weft::tools
