#include "budget/plain_name.hpp"

namespace spanline::host {

std::string plain_name(const std::string& demangled) {
  static const std::string kAnonymous = "(anonymous namespace)::", kOperator = "operator";
  std::string name;
  int depth = 0;
  for (std::size_t i = 0; i < demangled.size(); ++i) {
    if (demangled.compare(i, kAnonymous.size(), kAnonymous) == 0) {
      i += kAnonymous.size() - 1;
      continue;
    }
    const char c = demangled[i];
    const bool after_operator = name.size() >= kOperator.size() &&
                                name.compare(name.size() - kOperator.size(), kOperator.size(), kOperator) == 0;
    if (depth == 0 && after_operator && (c == '(' || c == '<')) {
      name += c;  // the operator's own sign
      if (c == '(') name += demangled[++i];
      continue;
    }
    if (depth == 0 && c == '(') break;
    if (c == '<') ++depth;
    if (depth == 0) name += c;
    if (c == '>' && depth > 0) --depth;
  }
  const std::size_t space = name.rfind(' ');
  return space == std::string::npos || name.find(kOperator) != std::string::npos ? name : name.substr(space + 1);
}

}  // namespace spanline::host
