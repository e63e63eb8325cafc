#include <algorithm>
#include <array>
#include <optional>

#include "assetc/obj.hpp"
#include "assetc/text_file.hpp"

namespace spanline::host {
namespace {

// Statements of the format that concern other renderers.
constexpr std::array<std::string_view, 23> kPassedOver = {
    "Ka",     "Ks",     "Ke",    "Ns",       "Ni",       "illum", "map_Ka",   "map_Kd",
    "map_Ks", "map_Ns", "map_d", "map_Bump", "map_bump", "bump",  "disp",     "decal",
    "refl",   "norm",   "Pr",    "Pm",       "Ps",       "Pc",    "sharpness"};

double read_part(const WordLines& lines, std::size_t word) {
  const double value = lines.number(word);
  if (value < 0 || value > 1) lines.fail("'" + printable(lines.words()[word]) + "' is not between 0 and 1");
  return value;
}

Vec3 read_color(const WordLines& lines) {
  if (lines.words().size() != 4) lines.fail("'" + printable(lines.words()[0]) + "' needs 3 numbers");
  return {read_part(lines, 1), read_part(lines, 2), read_part(lines, 3)};
}

// Of `d` and `Tr`; a halo is not told from the rest.
double read_single(const WordLines& lines) {
  const std::size_t first = lines.words().size() > 1 && lines.words()[1] == "-halo" ? 2 : 1;
  if (lines.words().size() != first + 1) lines.fail("'" + printable(lines.words()[0]) + "' needs a number");
  return read_part(lines, first);
}

Color color_of(Vec3 parts) { return {channel(parts.x), channel(parts.y), channel(parts.z)}; }

// What an MTL file says of how light comes through a material.
struct Glass {
  std::optional<double> opacity, transparency;
  Vec3 filter{1, 1, 1};

  Color transmission() const {
    const double part = opacity ? 1 - *opacity : transparency.value_or(0);
    return color_of(part * filter);
  }
};

}  // namespace

std::vector<ObjMaterial> parse_mtl(const std::string& name, std::string_view text) {
  WordLines lines(name, text);
  std::vector<ObjMaterial> materials;
  Glass glass;
  while (lines.next()) {
    const std::string_view statement = lines.words()[0];
    if (statement == "newmtl") {
      if (lines.words().size() < 2) lines.fail("'newmtl' needs a name");
      materials.push_back({lines.rest(), {255, 255, 255}});
      glass = {};
      continue;
    }
    if (materials.empty()) lines.fail("'" + printable(statement) + "' stands before the first 'newmtl'");
    if (statement == "Kd") {
      materials.back().color = color_of(read_color(lines));
    } else if (statement == "d") {
      glass.opacity = read_single(lines);
    } else if (statement == "Tr") {
      glass.transparency = read_single(lines);
    } else if (statement == "Tf") {
      glass.filter = read_color(lines);
    } else if (std::find(kPassedOver.begin(), kPassedOver.end(), statement) == kPassedOver.end()) {
      lines.fail("unknown statement '" + printable(statement) + "'");
    }
    materials.back().transmission = glass.transmission();
  }
  return materials;
}

std::vector<ObjMaterial> read_mtl(const std::string& path) { return parse_mtl(path, read_file(path)); }

}  // namespace spanline::host
