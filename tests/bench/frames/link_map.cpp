#include "frames/link_map.hpp"

#include <array>
#include <fstream>
#include <sstream>

#include "assetc/input_error.hpp"

namespace spanline::bench {
namespace {

// Rooms of firmware/core, and what comes with the compiler.
constexpr std::array kLibraries = {"libspanline_base.", "libspanline_fx.",    "libspanline_scene.",
                                   "libspanline_geom.", "libspanline_vsg.",   "libspanline_curve.",
                                   "libspanline_area.", "libspanline_shade.", "libspanline_frame.",
                                   "libgcc.a",          "libc_nano.a"};

bool of_engine(const std::string& member) {
  const std::string file = member.substr(member.rfind('/') + 1);
  for (const char* library : kLibraries) {
    if (file.rfind(library, 0) == 0) return true;
  }
  return false;
}

// What a template of the engine's became in an image's own files; the section's name ends with the symbol's.
bool is_engine_template(const std::string& section) {
  static const std::string kEngine = "8spanline";
  const std::size_t at = section.find(kEngine);
  if (at == std::string::npos || section.find("._ZN") == std::string::npos) return false;
  const std::string rest = section.substr(at + kEngine.size());
  for (const char* other : {"5bench", "6target", "6boards", "3hal", "5demos"}) {
    if (rest.rfind(other, 0) == 0) return false;
  }
  return true;
}

bool is_text(const std::string& section) { return section.rfind(".text", 0) == 0 || section.rfind(".rodata", 0) == 0; }

}  // namespace

// A contribution is " .text.name 0xADDRESS 0xSIZE member", broken in two lines after a long name.
std::vector<Contribution> engine_contributions(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw host::InputError(path, "cannot be read");
  std::vector<Contribution> found;
  bool placed = false;  // what comes before the memory map was thrown away
  std::string section;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("Linker script and memory map", 0) == 0) placed = true;
    if (!placed || line.empty() || line[0] != ' ') continue;
    std::istringstream words(line);
    if (line[1] != ' ') words >> section;
    std::string address, size, member;
    if (!(words >> address >> size >> member) || address.rfind("0x", 0) != 0 || size.rfind("0x", 0) != 0) continue;
    if (is_text(section) && (of_engine(member) || is_engine_template(section)))
      found.push_back({section, member, static_cast<std::uint32_t>(std::stoul(size, nullptr, 16))});
    section.clear();
  }
  if (found.empty()) throw host::InputError(path, "is no map of an image with the engine in it");
  return found;
}

std::uint32_t engine_text_bytes(const std::string& path) {
  std::uint32_t bytes = 0;
  for (const Contribution& one : engine_contributions(path)) bytes += one.size;
  return bytes;
}

}  // namespace spanline::bench
