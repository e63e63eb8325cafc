#include "mesh.hpp"

namespace spanline::make {

namespace {

constexpr int kPositionDigits = 4;  // a unit mesh on 320 pixels: far below a sixteenth of a pixel
constexpr int kNormalDigits = 3;    // the engine keeps 9 bits and a sign

constexpr long power10(int digits) { return digits == 0 ? 1 : 10 * power10(digits - 1); }

// Fixed-point text without trailing zeros; integers only, so that the file does not depend on a library's float
// printing.
std::string decimal(long value, int digits) {
  const long whole = power10(digits);
  std::string fraction = std::to_string(whole + std::abs(value) % whole).substr(1);
  fraction.erase(fraction.find_last_not_of('0') + 1);
  const std::string text = std::to_string(std::abs(value) / whole) + (fraction.empty() ? "" : "." + fraction);
  return value < 0 ? "-" + text : text;
}

void write_pool(std::ostream& out, const char* keyword, const std::vector<std::array<long, 3>>& values, int digits) {
  for (const auto& value : values) {
    out << keyword << ' ' << decimal(value[0], digits) << ' ' << decimal(value[1], digits) << ' '
        << decimal(value[2], digits) << '\n';
  }
}

Vec newell_normal(const std::vector<Vec>& corners) {
  Vec sum;
  for (std::size_t i = 0; i < corners.size(); ++i) sum = sum + cross(corners[i], corners[(i + 1) % corners.size()]);
  return unit(sum);
}

}  // namespace

int Mesh::Pool::add(Vec value, double scale) {
  const Key key = {std::lround(value.x * scale), std::lround(value.y * scale), std::lround(value.z * scale)};
  const auto [place, added] = index.emplace(key, static_cast<int>(values.size()));
  if (added) values.push_back(key);
  return place->second;
}

void Mesh::face(const std::vector<Corner>& corners) {
  Face made{{}, material_};
  for (const Corner& corner : corners) {
    const int position = positions_.add(corner.position, power10(kPositionDigits));
    if (!made.corners.empty() && made.corners.back()[0] == position) continue;
    made.corners.push_back({position, normals_.add(corner.normal, power10(kNormalDigits))});
  }
  if (made.corners.size() > 1 && made.corners.back()[0] == made.corners.front()[0]) made.corners.pop_back();
  if (made.corners.size() >= 3) faces_.push_back(made);
}

void Mesh::flat(const std::vector<Vec>& corners) {
  const Vec normal = newell_normal(corners);
  std::vector<Corner> flat_corners;
  flat_corners.reserve(corners.size());
  for (const Vec& corner : corners) flat_corners.push_back({corner, normal});
  face(flat_corners);
}

void Mesh::material(const std::string& name) { material_ = name; }

void Mesh::write(std::ostream& out, const std::string& comment, const std::string& mtl) const {
  out << "# " << comment << "\n# " << positions_.values.size() << " vertices, " << normals_.values.size()
      << " normals, " << faces_.size() << " faces; made by spanline-meshgen\n";
  if (!mtl.empty()) out << "mtllib " << mtl << '\n';
  write_pool(out, "v", positions_.values, kPositionDigits);
  write_pool(out, "vn", normals_.values, kNormalDigits);
  std::string worn;
  for (const Face& face : faces_) {
    if (face.material != worn) {
      worn = face.material;
      out << "usemtl " << worn << '\n';
    }
    out << 'f';
    for (const auto& [position, normal] : face.corners) out << ' ' << position + 1 << "//" << normal + 1;
    out << '\n';
  }
}

}  // namespace spanline::make
