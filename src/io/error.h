// The ways a file can go wrong; the program turns them into exit codes.
//
// Texts read `<where>: <problem> (<why it is one>) <what to do>`, on one line.
#pragma once

#include <stdexcept>
#include <string>

namespace weft::io {

/// Something that was read is wrong.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Something could not be written.
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Something that this machine or this build does not have was asked for.
struct UnavailableError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace weft::io
