#include <algorithm>
#include <array>

#include "assetc/obj.hpp"
#include "assetc/text_file.hpp"

namespace spanline::host {
namespace {

// Statements of the format that concern other renderers.
constexpr std::array<std::string_view, 26> kPassedOver = {
    "Ka",     "Ks",     "Ke",     "Ns",     "Ni",    "d",        "Tr",       "Tf",       "illum",
    "map_Ka", "map_Kd", "map_Ks", "map_Ns", "map_d", "map_Bump", "map_bump", "bump",     "disp",
    "decal",  "refl",   "norm",   "Pr",     "Pm",    "Ps",       "Pc",       "sharpness"};

Color read_color(const WordLines& lines) {
  if (lines.words().size() != 4) lines.fail("'Kd' needs 3 numbers");
  std::array<std::uint8_t, 3> channels{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double value = lines.number(i + 1);
    if (value < 0 || value > 1) lines.fail("'" + printable(lines.words()[i + 1]) + "' is not between 0 and 1");
    channels[i] = channel(value);
  }
  return {channels[0], channels[1], channels[2]};
}

}  // namespace

std::vector<ObjMaterial> parse_mtl(const std::string& name, std::string_view text) {
  WordLines lines(name, text);
  std::vector<ObjMaterial> materials;
  while (lines.next()) {
    const std::string_view statement = lines.words()[0];
    if (statement == "newmtl") {
      if (lines.words().size() < 2) lines.fail("'newmtl' needs a name");
      materials.push_back({lines.rest(), {255, 255, 255}});
      continue;
    }
    if (materials.empty()) lines.fail("'" + printable(statement) + "' stands before the first 'newmtl'");
    if (statement == "Kd") {
      materials.back().color = read_color(lines);
    } else if (std::find(kPassedOver.begin(), kPassedOver.end(), statement) == kPassedOver.end()) {
      lines.fail("unknown statement '" + printable(statement) + "'");
    }
  }
  return materials;
}

std::vector<ObjMaterial> read_mtl(const std::string& path) { return parse_mtl(path, read_file(path)); }

}  // namespace spanline::host
