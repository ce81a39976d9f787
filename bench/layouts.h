// Other ways to store a mesh's springs, as plain loops, to be compared with weft's: what Georgii
// and Westermann 2005 did, what is commonly done, and every spring once on a grid.
#pragma once

#include <memory>

#include "bench/interleave.h"
#include "bench/sheets.h"

namespace weft::bench {

/// A step of a sheet in each of them: forces and the summed Verlet update, in float.
///   compressed rows:  neighbour and rest length of each vertex one after the other
///   padded rows:      as many entries for every vertex as the largest valence, entry by entry
///                     (Georgii and Westermann 2005, section 4.1)
Candidate compressed_rows(const std::string& name, const TriangleSheet&, const char* isa);
Candidate padded_rows(const std::string& name, const TriangleSheet&, const char* isa);
/// The n x n valence-6 grid, every spring once: the rows above take their share as they are made.
Candidate each_once(const std::string& name, uint32_t n, const char* isa);

/// Bytes of the springs in the padded layout.
double padded_bytes(const TriangleSheet&);

}  // namespace weft::bench
