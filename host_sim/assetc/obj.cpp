#include "assetc/obj.hpp"

#include <array>

#include "assetc/text_file.hpp"

namespace spanline::host {
namespace {

constexpr std::size_t kMaxFaces = kMaxSceneFaces;
constexpr std::size_t kMaxVertices = 0x7fffffff;  // indices are 31 bits

struct ReadState {
  WordLines& lines;
  ObjMesh mesh;
  std::map<std::string, std::int32_t> material_by_name;
  std::int64_t texture_points = 0;
  std::int32_t largest_texture = kNone;
  std::size_t largest_texture_line = 0;
  std::int32_t material = kNone;
  bool has_library = false;
};

Vec3 read_point(const WordLines& lines) { return {lines.number(1), lines.number(2), lines.number(3)}; }

void read_position(ReadState& state) {
  const std::size_t numbers = state.lines.words().size() - 1;
  // Four: a weight; six: a colour, as some scanners write.
  if (numbers != 3 && numbers != 4 && numbers != 6) state.lines.fail("'v' needs 3 numbers");
  for (std::size_t i = 4; i <= numbers; ++i) state.lines.number(i);
  if (numbers == 4 && state.lines.number(4) != 1) state.lines.fail("a vertex weight other than 1 is not supported");
  if (state.mesh.positions.size() == kMaxVertices) state.lines.fail("too many vertices");
  state.mesh.positions.push_back(read_point(state.lines));
  state.mesh.position_lines.push_back(static_cast<std::uint32_t>(state.lines.line()));
}

void read_normal(ReadState& state) {
  if (state.lines.words().size() != 4) state.lines.fail("'vn' needs 3 numbers");
  state.mesh.normals.push_back(read_point(state.lines));
}

void read_texture_point(ReadState& state) {
  const std::size_t words = state.lines.words().size();
  if (words < 2 || words > 4) state.lines.fail("'vt' needs 1 to 3 numbers");
  for (std::size_t i = 1; i < words; ++i) state.lines.number(i);
  ++state.texture_points;
}

// An index of a face as the file writes it, from 0. A negative one counts back from the latest of `so_far`; a positive
// one may be ahead of its element, so its upper end is checked when the file is read.
std::int32_t read_index(const ReadState& state, std::string_view text, std::int64_t so_far, const char* kind) {
  std::int64_t written = 0;
  const std::string shown = "'" + printable(text) + "'";
  if (!parse_whole(text, written)) state.lines.fail(shown + " is not a " + kind + " index");
  if (written == 0) state.lines.fail(std::string("a ") + kind + " index is 0; they count from 1");
  const bool in_range = written > 0 ? written <= INT32_MAX : written >= -so_far;
  if (!in_range) state.lines.fail(std::string(kind) + " index " + shown + " is out of range");
  return static_cast<std::int32_t>(written > 0 ? written - 1 : so_far + written);
}

struct CornerIndices {
  std::int32_t position = kNone, texture = kNone, normal = kNone;
};

// "v", "v/vt", "v//vn" or "v/vt/vn".
CornerIndices read_corner(const ReadState& state, std::string_view word) {
  CornerIndices corner;
  const std::size_t first = word.find('/');
  corner.position = read_index(state, word.substr(0, first), std::ssize(state.mesh.positions), "vertex");
  if (first == std::string_view::npos) return corner;
  const std::string_view behind = word.substr(first + 1);
  const std::size_t second = behind.find('/');
  const std::string_view texture = behind.substr(0, second);
  if (!texture.empty() || second == std::string_view::npos) {
    corner.texture = read_index(state, texture, state.texture_points, "texture");
  }
  if (second != std::string_view::npos) {
    corner.normal = read_index(state, behind.substr(second + 1), std::ssize(state.mesh.normals), "normal");
  }
  return corner;
}

void refuse_repeats(const ReadState& state, const ObjFace& face) {
  const ObjCorner* corners = &state.mesh.corners[face.first_corner];
  for (std::uint32_t i = 0; i < face.corner_count; ++i) {
    const std::int32_t here = corners[i].position;
    if (here == corners[(i + 1) % face.corner_count].position) {
      state.lines.fail("the face has vertex " + std::to_string(here + 1) + " twice in a row");
    }
  }
}

void read_face(ReadState& state) {
  const auto& words = state.lines.words();
  if (words.size() < 4) state.lines.fail("a face needs at least 3 vertices");
  if (state.mesh.faces.size() == kMaxFaces) state.lines.fail("more than 65535 faces in one mesh");
  if (words.size() - 1 > 65535) state.lines.fail("a face has more than 65535 vertices");
  const ObjFace face{static_cast<std::uint32_t>(state.mesh.corners.size()),
                     static_cast<std::uint32_t>(words.size() - 1), state.material,
                     static_cast<std::uint32_t>(state.lines.line())};
  for (std::size_t i = 1; i < words.size(); ++i) {
    const CornerIndices corner = read_corner(state, words[i]);
    state.mesh.corners.push_back({corner.position, corner.normal});
    if (corner.texture > state.largest_texture) {
      state.largest_texture = corner.texture;
      state.largest_texture_line = face.line;
    }
  }
  refuse_repeats(state, face);
  state.mesh.faces.push_back(face);
}

void read_library(ReadState& state) {
  const std::string file = state.lines.rest();
  if (file.empty()) state.lines.fail("'mtllib' needs a file name");
  state.has_library = true;
  std::vector<ObjMaterial> materials;
  try {
    materials = read_mtl(path_beside(state.lines.name(), file));
  } catch (const InputError& error) {
    state.lines.fail(error.what());
  }
  for (ObjMaterial& material : materials) {
    state.material_by_name[material.name] = static_cast<std::int32_t>(state.mesh.materials.size());
    state.mesh.materials.push_back(std::move(material));
  }
}

void use_material(ReadState& state) {
  const std::string name = state.lines.rest();
  if (name.empty()) state.lines.fail("'usemtl' needs a name");
  const auto found = state.material_by_name.find(name);
  if (found == state.material_by_name.end()) {
    state.lines.fail("material '" + printable(name) + "' is defined by no " +
                     (state.has_library ? "material library above" : "material library: there is no 'mtllib' above"));
  }
  state.material = found->second;
}

void refuse_beyond(const std::string& name, std::size_t line, const char* kind, std::int64_t index,
                   std::int64_t count) {
  if (index < count) return;
  throw InputError(name, line,
                   std::string(kind) + " index " + std::to_string(index + 1) + " is out of range: the file has " +
                       std::to_string(count));
}

void check_forward_indices(const ReadState& state, const std::string& name) {
  const ObjMesh& mesh = state.mesh;
  for (const ObjFace& face : mesh.faces) {
    for (std::uint32_t i = 0; i < face.corner_count; ++i) {
      const ObjCorner& corner = mesh.corners[face.first_corner + i];
      refuse_beyond(name, face.line, "vertex", corner.position, std::ssize(mesh.positions));
      refuse_beyond(name, face.line, "normal", corner.normal, std::ssize(mesh.normals));
    }
  }
  refuse_beyond(name, state.largest_texture_line, "texture", state.largest_texture, state.texture_points);
}

}  // namespace

ObjMesh parse_obj(const std::string& name, std::string_view text) {
  WordLines lines(name, text);
  ReadState state{lines, {}, {}};
  while (lines.next()) {
    const std::string_view statement = lines.words()[0];
    if (statement == "v") {
      read_position(state);
    } else if (statement == "vn") {
      read_normal(state);
    } else if (statement == "vt") {
      read_texture_point(state);
    } else if (statement == "f") {
      read_face(state);
    } else if (statement == "mtllib") {
      read_library(state);
    } else if (statement == "usemtl") {
      use_material(state);
    } else if (statement != "o" && statement != "g" && statement != "s") {
      lines.fail("unknown statement '" + printable(statement) + "'");
    }
  }
  if (state.mesh.faces.empty()) throw InputError(name, "has no faces");
  check_forward_indices(state, name);
  return std::move(state.mesh);
}

ObjMesh read_obj(const std::string& path) { return parse_obj(path, read_file(path)); }

}  // namespace spanline::host
