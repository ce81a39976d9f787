// Large triangles in pieces, so that a part of them can give way.
#pragma once

#include "io/mesh.h"

namespace weft::render {

/// The same surface with no edge longer than `longest`, or about 50,000 triangles. Edges in one
/// place are cut in one place, so that nothing opens between triangles.
io::Mesh subdivided(const io::Mesh&, double longest);

/// No fewer triangles than that has; without making them.
size_t most_pieces(const io::Mesh&, double longest);

}  // namespace weft::render
