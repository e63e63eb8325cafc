#include "assetc/text_file.hpp"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace spanline::host {
namespace {

constexpr std::string_view kBlanks = " \t\r\v\f";

template <typename T>
bool parse_all(std::string_view text, T& value) {
  if (text.starts_with('+') && text.size() > 1 && text[1] != '-') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

// Appends the words of `text`.
void split(std::string_view text, std::vector<std::string_view>& words) {
  for (std::size_t start = text.find_first_not_of(kBlanks); start != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, start), text.size());
    words.push_back(text.substr(start, end - start));
    start = text.find_first_not_of(kBlanks, end);
  }
}

}  // namespace

std::string one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  }
  return text;
}

std::string printable(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string shown(text.substr(0, kLongest));
  for (char& c : shown) {
    if (c < ' ' || c > '~') c = '?';
  }
  return text.size() > kLongest ? shown + "…" : shown;
}

std::string read_file(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw InputError(path, "no such file");
  if (std::filesystem::is_directory(path, error)) throw InputError(path, "is a directory");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(path, "cannot be opened");
  std::string text;
  char block[65536];
  while (in.read(block, sizeof block) || in.gcount() > 0) {
    text.append(block, static_cast<std::size_t>(in.gcount()));
    if (text.size() > kMaxFileBytes) throw InputError(path, "is larger than 256 MB");
  }
  if (in.bad()) throw InputError(path, "cannot be read");
  return text;
}

std::string path_beside(const std::string& file, const std::string& relative) {
  return (std::filesystem::path(file).parent_path() / relative).lexically_normal().string();
}

bool parse_number(std::string_view text, double& value) {
  return parse_all(text, value) && std::isfinite(value) && std::fabs(value) <= kMaxCoordinate;
}

bool parse_whole(std::string_view text, std::int64_t& value) { return parse_all(text, value); }

WordLines::WordLines(std::string name, std::string_view text) : name_(std::move(name)), text_(text) {
  std::size_t line = 1;
  for (const char c : text) {
    if (c == '\0') throw InputError(name_, line, "holds a NUL byte: not a text file");
    if (c == '\n') ++line;
  }
}

bool WordLines::take_physical_line() {
  const std::size_t end = std::min(text_.find('\n', next_), text_.size());
  std::string_view line = text_.substr(next_, end - next_);
  next_ = end + 1;
  ++line_;
  if (line.ends_with('\r')) line.remove_suffix(1);
  const bool continued = line.ends_with('\\') && line.find('#') == std::string_view::npos;
  if (continued) line.remove_suffix(1);
  split(line.substr(0, line.find('#')), words_);
  return continued;
}

bool WordLines::next() {
  while (next_ < text_.size()) {
    words_.clear();
    first_line_ = line_ + 1;
    while (take_physical_line()) {
      if (next_ >= text_.size()) fail("the file ends in a continued line");
    }
    if (!words_.empty()) return true;
  }
  return false;
}

double WordLines::number(std::size_t index) const {
  double value = 0;
  if (!parse_number(words_[index], value)) {
    fail("'" + printable(words_[index]) + "' is not a number between -1e12 and 1e12");
  }
  return value;
}

std::string WordLines::rest() const {
  if (words_.size() < 2) return {};
  const std::string_view last = words_.back();
  std::string rest(words_[1].data(), last.data() + last.size());
  if (rest.find('\n') != std::string::npos) fail("a name cannot be continued on the next line");
  return rest;
}

}  // namespace spanline::host
