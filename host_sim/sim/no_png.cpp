// Stands for png.cpp in builds without libpng.
#include "sim/picture.hpp"
#include "sim/usage_error.hpp"

namespace spanline::host {

bool png_available() { return false; }

std::string encode_png(const Picture&) { throw UsageError("this build has no libpng"); }

Picture read_png(const std::string& path) { throw UsageError(path + ": this build has no libpng to read it"); }

}  // namespace spanline::host
