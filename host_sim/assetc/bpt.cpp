#include "assetc/bpt.hpp"

#include <algorithm>

#include "assetc/text_file.hpp"

namespace spanline::host {
namespace {

constexpr std::int64_t kMostPatches = 65535;  // faces have 16-bit numbers, and a patch is one
constexpr std::int64_t kMostVertices = 16 * kMostPatches;

// Commas count as blanks.
std::string without_commas(std::string_view text) {
  std::string blanks(text);
  std::replace(blanks.begin(), blanks.end(), ',', ' ');
  return blanks;
}

// Numbers one after the other, wherever the lines end.
class BptReader {
 public:
  BptReader(const std::string& name, std::string_view text) : text_(without_commas(text)), lines_(name, text_) {}

  std::vector<BptPatch> read() {
    if (!lines_.next())
      throw InputError(lines_.name(), 1, "the file is empty; its first line is the number of patches");
    patch_count_ = static_cast<std::size_t>(count("patches", kMostPatches));
    if (next_ < lines_.words().size()) lines_.fail("the number of patches stands alone on its line");
    part_.of = patch_count_;
    if (!lines_.next()) fail_at_end();
    const std::size_t words = lines_.words().size();
    next_ = 0;
    std::vector<BptPatch> patches = words == 16 ? indexed_patches() : patches_of_points(words == 2);
    if (next_ < lines_.words().size() || lines_.next()) {
      lines_.fail("there is more after the " + std::to_string(patch_count_) + " patches that the first line promises");
    }
    return patches;
  }

 private:
  [[noreturn]] void fail_at_end() const {
    lines_.fail(std::string("the file ends in ") + part_.name + ' ' + std::to_string(part_.number) + " of " +
                std::to_string(part_.of));
  }

  // The index of the next word of the current line, which may be the next line.
  std::size_t word() {
    if (next_ == lines_.words().size()) {
      if (!lines_.next()) fail_at_end();
      next_ = 0;
    }
    return next_++;
  }

  std::int64_t whole(const std::string& what, std::int64_t most) {
    const std::string_view text = lines_.words()[word()];
    std::int64_t value = 0;
    if (!parse_whole(text, value) || value < 1 || value > most) {
      lines_.fail("'" + printable(text) + "' is not a " + what + " from 1 to " + std::to_string(most));
    }
    return value;
  }
  std::int64_t count(const char* of, std::int64_t most) { return whole(std::string("number of ") + of, most); }

  Vec3 point() {
    const auto number = [&] {
      const std::size_t index = word();
      return lines_.number(index);
    };
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }

  void degrees() {
    for (int i = 0; i < 2; ++i) {
      const std::string_view text = lines_.words()[word()];
      if (text != "3") lines_.fail("'" + printable(text) + "' is not the degree 3: only bicubic patches are read");
    }
  }

  std::vector<BptPatch> patches_of_points(bool with_degrees) {
    std::vector<BptPatch> patches;
    while (patches.size() < patch_count_) {
      part_ = {"patch", patches.size() + 1, patch_count_};
      if (with_degrees) degrees();
      BptPatch patch;
      for (auto& row : patch.points) {
        for (Vec3& p : row) {
          p = point();
          if (patch.line == 0) patch.line = lines_.line();
        }
      }
      patches.push_back(patch);
    }
    return patches;
  }

  std::vector<BptPatch> indexed_patches() {
    struct Corners {
      std::array<std::int64_t, 16> vertices;
      std::size_t line;
    };
    std::vector<Corners> all;
    while (all.size() < patch_count_) {
      part_ = {"patch", all.size() + 1, patch_count_};
      Corners corners;
      for (std::int64_t& vertex : corners.vertices) vertex = whole("vertex number", kMostVertices);
      corners.line = lines_.line();
      all.push_back(corners);
    }
    std::vector<Vec3> vertices(static_cast<std::size_t>(count("vertices", kMostVertices)));
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      part_ = {"vertex", i + 1, vertices.size()};
      vertices[i] = point();
    }
    std::vector<BptPatch> patches;
    for (const Corners& corners : all) {
      BptPatch patch;
      patch.line = corners.line;
      for (std::size_t i = 0; i < 16; ++i) {
        const auto vertex = static_cast<std::size_t>(corners.vertices[i]);
        if (vertex > vertices.size()) {
          throw InputError(
              lines_.name(), corners.line,
              "vertex " + std::to_string(vertex) + " does not exist: the file has " + std::to_string(vertices.size()));
        }
        patch.points[i / 4][i % 4] = vertices[vertex - 1];
      }
      patches.push_back(patch);
    }
    return patches;
  }

  std::string text_;
  WordLines lines_;
  std::size_t next_ = 0;
  std::size_t patch_count_ = 0;
  struct {
    const char* name = "patch";
    std::size_t number = 1, of = 1;
  } part_;  // what is being read, for fail_at_end()
};

}  // namespace

std::vector<BptPatch> read_bpt(const std::string& path) { return parse_bpt(path, read_file(path)); }

std::vector<BptPatch> parse_bpt(const std::string& name, std::string_view text) { return BptReader(name, text).read(); }

}  // namespace spanline::host
