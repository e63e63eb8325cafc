#include "assetc/curve_json.hpp"

#include <cmath>

#include "assetc/isocurves.hpp"
#include "assetc/svg_path.hpp"
#include "assetc/text_file.hpp"

namespace spanline::host {
namespace {

constexpr std::size_t kMostCurves = 65535;

CurveRecord::Kind read_kind(const JsonNode& node) {
  const std::string kind = node.text();
  if (kind == "bezier") return CurveRecord::kBezier;
  if (kind == "quadratic") return CurveRecord::kQuadratic;
  if (kind == "b-spline") return CurveRecord::kBSpline;
  if (kind == "catmull-rom") return CurveRecord::kCatmullRom;
  node.fail("must be one of \"b-spline\", \"bezier\", \"catmull-rom\", \"quadratic\"");
}

// What a stroke looks like, whatever its points.
MeshCurve read_look(const JsonNode& node, std::int32_t material, const MaterialOf& material_of) {
  constexpr double kMaxPx = CurveRecord::kMaxWidth / 16.0;
  MeshCurve curve;
  curve.material = material;
  if (const auto given = node.find("material")) curve.material = material_of(*given);
  curve.width = node.find("width") ? node.require("width").number(0, kMaxPx) : 1;
  curve.smooth = !node.find("smooth") || node.require("smooth").boolean();
  return curve;
}

void append_points(MeshSource& mesh, const std::vector<Vec3>& points) {
  for (const Vec3& point : points) {
    mesh.corners.push_back({static_cast<std::int32_t>(mesh.positions.size())});
    mesh.positions.push_back(point);
  }
}

void append(const JsonNode& node, MeshSource& mesh, MeshCurve curve, const std::vector<Vec3>& points) {
  if (mesh.curves.size() == kMostCurves) node.fail("more than 65535 curves in one mesh");
  if (points.size() > 65535) node.fail("has more than 65535 points");
  curve.first_corner = static_cast<std::uint32_t>(mesh.corners.size());
  curve.point_count = static_cast<std::uint16_t>(points.size());
  if (curve.record(0).pieces() == 0)
    node.fail("has " + std::to_string(points.size()) + " points: no whole number of pieces");
  append_points(mesh, points);
  mesh.curves.push_back(curve);
}

void read_curve(const JsonNode& node, MeshSource& mesh, std::int32_t material, const MaterialOf& material_of) {
  MeshCurve curve = read_look(node, material, material_of);
  if (const auto path = node.find("path")) {
    node.allow_keys({"path", "width", "smooth", "material"});
    for (const PathContour& contour : read_svg_path(*path)) {
      curve.closed = contour.closed;
      append(*path, mesh, curve, contour.points);
    }
    return;
  }
  node.allow_keys({"kind", "points", "closed", "width", "smooth", "material"});
  curve.kind = read_kind(node.require("kind"));
  if (const auto closed = node.find("closed")) curve.closed = closed->boolean();
  const JsonNode list = node.require("points");
  std::vector<Vec3> points;
  for (const JsonNode& point : list.elements(1)) points.push_back(point.point());
  append(list, mesh, curve, points);
}

}  // namespace

void read_curves(const JsonNode& node, MeshSource& mesh, std::int32_t material, const MaterialOf& material_of) {
  for (const JsonNode& each : node.elements(1)) {
    if (!each.is_object()) each.fail("must be an object");
    read_curve(each, mesh, material, material_of);
  }
}

void read_outlines(const JsonNode& node, MeshSource& mesh, std::int32_t material, const MaterialOf& material_of) {
  for (const JsonNode& each : node.elements(1)) {
    if (!each.is_object()) each.fail("must be an object");
    each.allow_keys({"path", "material"});
    const std::int32_t own = each.find("material") ? material_of(each.require("material")) : material;
    const JsonNode path = each.require("path");
    MeshFace face{static_cast<std::uint32_t>(mesh.corners.size()),
                  0,
                  static_cast<std::uint32_t>(mesh.rings.size()),
                  0,
                  own,
                  true};
    const std::vector<PathContour> contours = read_svg_path(path);
    for (const PathContour& contour : contours) {
      if (!contour.closed) path.fail("a subpath is not closed");
      if (contour.points.size() < 6) path.fail("a subpath has fewer than two pieces");
      face.corner_count += static_cast<std::uint32_t>(contour.points.size());
      if (face.corner_count > 65535) path.fail("has more than 65535 points");
      if (contours.size() > 1) mesh.rings.push_back(static_cast<std::uint16_t>(contour.points.size()));
      append_points(mesh, contour.points);
    }
    face.ring_count = static_cast<std::uint32_t>(contours.size());
    mesh.faces.push_back(face);
  }
}

void read_isocurves(const JsonNode& node, MeshSource& mesh, std::int32_t material, const MaterialOf& material_of) {
  node.allow_keys({"bpt", "u", "v", "width", "smooth", "material"});
  constexpr int kMostLines = 64;
  const auto count = [&](const char* key) {
    return node.find(key) ? static_cast<int>(node.require(key).whole(1, kMostLines)) : 2;
  };
  const int across = count("u"), down = count("v");
  const JsonNode file = node.require("bpt");
  std::vector<BptPatch> patches;
  try {
    patches = read_bpt(path_beside(node.file(), file.text()));
  } catch (const InputError& error) {
    file.fail(error.what());
  }
  const MeshCurve look = read_look(node, material, material_of);
  for (const BezierPoints& curve : isocurves(patches, across, down)) {
    append(file, mesh, look, {curve.begin(), curve.end()});
  }
}

}  // namespace spanline::host
