// Reading text files line by line and number by number, strictly.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "assetc/input_error.hpp"

namespace spanline::host {

inline constexpr std::size_t kMaxFileBytes = std::size_t{256} << 20;
inline constexpr double kMaxCoordinate = 1e12;  // keeps every sum and product of coordinates far inside a double

// The whole file. Throws InputError where it cannot be read or is larger than kMaxFileBytes.
std::string read_file(const std::string& path);

// `relative` as seen from the folder of `file`; an absolute path is left as it is.
std::string path_beside(const std::string& file, const std::string& relative);

// A finite decimal number and nothing else; |value| at most kMaxCoordinate. False for nan, inf, hexadecimal and junk.
bool parse_number(std::string_view text, double& value);

// A whole decimal number and nothing else.
bool parse_whole(std::string_view text, std::int64_t& value);

// The logical lines of an OBJ or MTL file: comments are cut, a backslash at the end joins the next line, CR LF ends a
// line like LF does, and lines without words are skipped.
class WordLines {
 public:
  // `name` goes into messages; `text` must outlive the object. Throws InputError at once where the text holds a NUL
  // byte.
  WordLines(std::string name, std::string_view text);

  // The words of the next line that has any; false at the end of the text.
  bool next();
  const std::vector<std::string_view>& words() const { return words_; }
  std::size_t line() const { return first_line_; }  // where the words began, from 1
  const std::string& name() const { return name_; }

  [[noreturn]] void fail(const std::string& text) const { throw InputError(name_, first_line_, text); }

  // The word at `index` as a number; fails with the word in the message.
  double number(std::size_t index) const;

  // What follows the first word, as it stands: file names may hold blanks. Fails where it runs over a continued line.
  std::string rest() const;

 private:
  bool take_physical_line();  // appends to words_; true where the line is continued

  std::string name_;
  std::string_view text_;
  std::size_t next_ = 0;
  std::size_t line_ = 0;
  std::size_t first_line_ = 0;
  std::vector<std::string_view> words_;
};

}  // namespace spanline::host
