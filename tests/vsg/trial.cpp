#include "vsg/trial.hpp"

#include <set>
#include <sstream>

#include "oracle/compare.hpp"
#include "oracle/random_polygon.hpp"

namespace spanline::test {
namespace {

constexpr std::int64_t kHalfUnit = 128;
constexpr std::int64_t kEngineDepthScale = 32;  // Q16.13 in Q16.8

// Projection may fold a thin polygon over itself by a sixteenth of a pixel. Which of its edges bound a chord is then
// open where they cross, and so is the depth.
std::set<std::uint32_t> folded_faces(const std::vector<oracle::Facet>& facets) {
  std::set<std::uint32_t> folded;
  for (const oracle::Facet& facet : facets) {
    std::vector<oracle::Contour> contours;
    for (const auto& ring : facet.contours) {
      oracle::Contour& contour = contours.emplace_back();
      for (const oracle::Vertex& v : ring) {
        const bool repeated = !contour.empty() && contour.back().x == v.x && contour.back().y == v.y;
        if (!repeated) contour.push_back({v.x, v.y});
      }
    }
    const bool triangle = contours.size() == 1 && contours[0].size() == 3;
    if (!triangle && !oracle::is_simple(contours)) folded.insert(facet.face);
  }
  return folded;
}

std::string wrong_depth(const Drawing& drawing, const oracle::Rendering& truth, const std::set<std::uint32_t>& exempt) {
  for (int line = 0; line < truth.height(); ++line) {
    for (int column = 0; column < truth.width(); ++column) {
      const std::uint32_t face = truth.face(column, line);
      if (face == oracle::kNone || drawing.faces.at(column, line) != face || exempt.count(face) != 0) continue;
      const auto pixel =
          static_cast<std::size_t>(line) * static_cast<std::size_t>(truth.width()) + static_cast<std::size_t>(column);
      const oracle::Depth drawn{drawing.depths[pixel], kEngineDepthScale};
      const oracle::Depth& exact = truth.candidates(column, line).front().depth;
      if (oracle::closer_than(drawn, exact, kHalfUnit)) continue;
      std::ostringstream text;
      text.precision(12);
      text << "column " << column << ", line " << line << ": face " << face << " has depth " << oracle::in_units(drawn)
           << ", exact is " << oracle::in_units(exact) << "\n";
      return text.str();
    }
  }
  return {};
}

std::string try_on_screen(Drawer& drawer, const std::vector<oracle::Facet>& facets, oracle::Layout layout,
                          const Choices& choices, std::int64_t tolerance) {
  oracle::SceneStore store = oracle::screen_scene(facets, layout);
  const SceneRecord record = store.record();
  SceneView scene;
  const Status status = SceneView::validate(record, scene);
  if (!status.ok()) return std::string("refused: ") + status.where + " " + status.field;
  return judge(drawer, scene, oracle::plain_camera(), facets, choices, tolerance);
}

std::vector<oracle::Facet> without(const std::vector<oracle::Facet>& facets, std::size_t index) {
  std::vector<oracle::Facet> rest = facets;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(index));
  for (std::size_t i = 0; i < rest.size(); ++i) rest[i].face = static_cast<std::uint32_t>(i);
  return rest;
}

std::string as_text(const std::vector<oracle::Facet>& facets) {
  std::ostringstream text;
  for (const oracle::Facet& facet : facets) {
    text << "  face " << facet.face << ":";
    for (const auto& contour : facet.contours) {
      text << " [";
      for (const oracle::Vertex& vertex : contour)
        text << " (" << vertex.x << " " << vertex.y << " " << vertex.z / 256 << ")";
      text << " ]";
    }
    text << "\n";
  }
  return text.str();
}

}  // namespace

std::string judge(Drawer& drawer, const SceneView& scene, const CameraRecord& camera,
                  const std::vector<oracle::Facet>& facets, const Choices& choices, std::int64_t tolerance) {
  const Drawing drawing = drawer.draw(scene, camera, choices);
  if (!drawing.broken.empty()) return drawing.broken + "\n";
  if (!drawing.status.ok()) {
    return std::string("status ") + std::to_string(static_cast<int>(drawing.status.code)) + " " + drawing.status.where +
           " index " + std::to_string(drawing.status.index) + " line " + std::to_string(drawing.status.line) + "\n";
  }
  const oracle::Rendering truth = oracle::render(drawing.faces.width, drawing.faces.height, facets);
  const std::vector<oracle::WrongPixel> wrong = oracle::compare(drawing.faces, truth, tolerance);
  return wrong.empty() ? wrong_depth(drawing, truth, folded_faces(facets)) : oracle::describe(wrong);
}

std::string judge_on_screen(Drawer& drawer, const std::vector<oracle::Facet>& facets, oracle::Layout layout,
                            const Choices& choices, std::int64_t tolerance) {
  std::string verdict = try_on_screen(drawer, facets, layout, choices, tolerance);
  if (verdict.empty()) return {};
  std::vector<oracle::Facet> fewest = facets;
  for (std::size_t i = fewest.size(); i-- > 0 && fewest.size() > 1;) {
    std::vector<oracle::Facet> fewer = without(fewest, i);
    const std::string still = try_on_screen(drawer, fewer, layout, choices, tolerance);
    if (still.empty()) continue;
    fewest = std::move(fewer);
    verdict = still;
  }
  return verdict + as_text(fewest);
}

}  // namespace spanline::test
