// Any bytes as a mesh file: a sound mesh, or refused with an InputError.
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  try {
    require_sound(weft::io::read_ply(text_of(data, size), "a.ply"));
  } catch (const weft::io::InputError& error) {
    require_message(error);
  }
  return 0;
}
