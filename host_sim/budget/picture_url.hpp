// A picture as a page holds it.
#pragma once

#include <string>

#include "sim/picture.hpp"

namespace spanline::host {

// A data URL of the picture as a BMP of 24 bits, which needs no packing.
std::string picture_url(const Picture& picture);

}  // namespace spanline::host
