// Bad input from outside: one line that names the file and the place in it.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace spanline::host {

// `text` with control characters as '?': what a file says cannot break a message into lines.
std::string one_line(std::string text);

// `text` with every byte that is not printable ASCII as '?', cut off after 40 characters: a quoted word of a message.
std::string printable(std::string_view text);

class InputError : public std::runtime_error {
 public:
  // `place` is a file name, or a file with a line ("cube.obj:12") or a JSON path ("s.json: /size").
  InputError(const std::string& place, const std::string& text) : std::runtime_error(one_line(place + ": " + text)) {}

  // `line` counts from 1.
  InputError(const std::string& file, std::size_t line, const std::string& text)
      : InputError(file + ":" + std::to_string(line), text) {}
};

}  // namespace spanline::host
