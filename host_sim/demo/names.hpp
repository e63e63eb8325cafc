#pragma once

#include <string>

#include "assetc/input_error.hpp"
#include "sim/usage_error.hpp"

namespace spanline::host {

// The item of `items` whose name is `name`. Throws a UsageError that begins with `what` and lists the names.
template <typename Items, typename NameOf>
const auto& by_name(const std::string& what, const Items& items, const std::string& name, NameOf name_of) {
  std::string known;
  for (const auto& item : items) {
    if (name == name_of(item)) return item;
    known += (known.empty() ? "" : ", ") + std::string(name_of(item));
  }
  throw UsageError(what + ": '" + printable(name) + "' is none of " + known);
}

}  // namespace spanline::host
