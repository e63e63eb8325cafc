// Output files appear whole or not at all.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace spanline::host {

// Writes `bytes` to a temporary file beside `path` and renames it. Throws InputError; then `path` is as it was before.
void write_file(const std::string& path, std::string_view bytes);

// "out.png" and 7 of at most 89 to "out-0007.png": at least four digits, as many as `last` needs.
std::string numbered_path(const std::string& path, std::int64_t frame, std::int64_t last);

bool file_exists(const std::string& path);

}  // namespace spanline::host
