#include "assetc/svg_path.hpp"

#include <cctype>
#include <charconv>
#include <string>

#include "assetc/text_file.hpp"

namespace spanline::host {
namespace {

Vec3 between(Vec3 a, Vec3 b, double part) { return a + part * (b - a); }

class PathReader {
 public:
  explicit PathReader(const JsonNode& node) : node_(node), text_(node.text()) {}

  std::vector<PathContour> run() {
    for (skip(); at_ < text_.size(); skip()) {
      if (std::isalpha(static_cast<unsigned char>(text_[at_]))) {
        command_ = text_[at_++];
      } else if (command_ == 0 || upper() == 'Z') {
        fail("a command is missing");
      }
      take_command();
      // Further points after a move are lines.
      if (command_ == 'M') command_ = 'L';
      if (command_ == 'm') command_ = 'l';
    }
    finish();
    if (contours_.empty()) node_.fail("is an empty path");
    return contours_;
  }

 private:
  char upper() const { return static_cast<char>(std::toupper(static_cast<unsigned char>(command_))); }
  bool relative() const { return command_ >= 'a'; }

  [[noreturn]] void fail(const std::string& text) const {
    node_.fail(text + " at offset " + std::to_string(at_) + " of the path");
  }

  void skip() {
    while (at_ < text_.size() && (std::isspace(static_cast<unsigned char>(text_[at_])) || text_[at_] == ',')) ++at_;
  }

  double number() {
    skip();
    const char* begin = text_.data() + at_;
    if (at_ < text_.size() && *begin == '+') ++begin;
    double value = 0;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error != std::errc() || !(std::fabs(value) <= kMaxCoordinate)) fail("a number is missing or out of range");
    at_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }

  Vec3 point() {
    const double x = number(), y = number();
    const Vec3 p{x, y, 0};
    return relative() ? here_ + p : p;
  }

  void take_command() {
    switch (upper()) {
      case 'M':
        finish();
        here_ = start_ = point();
        contour_ = {{here_}, false};
        drawing_ = true;
        break;
      case 'L':
        line(point());
        break;
      case 'H':
        line({number() + (relative() ? here_.x : 0), here_.y, 0});
        break;
      case 'V':
        line({here_.x, number() + (relative() ? here_.y : 0), 0});
        break;
      case 'C': {
        const Vec3 a = point(), b = point();
        cubic(a, b, point());
        break;
      }
      case 'S': {
        const Vec3 a = reflected("CS"), b = point();
        cubic(a, b, point());
        break;
      }
      case 'Q': {
        const Vec3 a = point();
        quadratic(a, point());
        break;
      }
      case 'T': {
        const Vec3 a = reflected("QT");
        quadratic(a, point());
        break;
      }
      case 'Z':
        close();
        break;
      default:
        fail(std::string("'") + command_ + "' is not a command that is understood (M L H V C S Q T Z)");
    }
    before_ = upper();
  }

  // The last control point mirrored at the current point, if the last command was one of `kinds`.
  Vec3 reflected(std::string_view kinds) const {
    return kinds.find(before_) != std::string_view::npos ? here_ + (here_ - control_) : here_;
  }

  void piece(Vec3 a, Vec3 b, Vec3 end) {
    if (!drawing_) fail("the subpath does not begin with a move");
    contour_.points.insert(contour_.points.end(), {a, b, end});
    here_ = end;
  }
  void line(Vec3 end) { piece(between(here_, end, 1.0 / 3), between(here_, end, 2.0 / 3), end); }
  void cubic(Vec3 a, Vec3 b, Vec3 end) {
    piece(a, b, end);
    control_ = b;
  }
  void quadratic(Vec3 a, Vec3 end) {
    piece(between(here_, a, 2.0 / 3), between(end, a, 2.0 / 3), end);
    control_ = a;
  }

  void close() {
    if (!drawing_) fail("there is nothing to close");
    if (!(here_ == start_)) line(start_);
    contour_.closed = true;
    finish();
    here_ = start_;
    contour_ = {{here_}, false};
  }

  // Puts the contour by; a move that nothing follows leaves none.
  void finish() {
    if (contour_.points.size() > 1) {
      if (contour_.closed) contour_.points.pop_back();
      contours_.push_back(contour_);
    } else if (drawing_ && before_ == 'M') {
      fail("a subpath has no pieces");
    }
    contour_ = {};
  }

  const JsonNode& node_;
  const std::string text_;
  std::size_t at_ = 0;
  char command_ = 0, before_ = 0;
  bool drawing_ = false;
  Vec3 here_, start_, control_;
  PathContour contour_;
  std::vector<PathContour> contours_;
};

}  // namespace

std::vector<PathContour> read_svg_path(const JsonNode& node) { return PathReader(node).run(); }

}  // namespace spanline::host
