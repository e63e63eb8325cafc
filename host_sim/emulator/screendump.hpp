// What an emulator's display shows, back in the panel's own pixels.
#pragma once

#include <string>

#include "sim/picture.hpp"

namespace spanline::host {

// A binary PPM with 8-bit samples (P6, 255). Throws InputError.
Picture read_ppm(const std::string& path);

// `dump` with every square of `scale` by `scale` pixels as one. Throws an InputError that names `path` where a square
// is not of one colour or the size is no multiple: then it shows something else than the panel.
Picture shrink(const Picture& dump, std::uint16_t scale, const std::string& path);

}  // namespace spanline::host
