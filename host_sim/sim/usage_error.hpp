#pragma once

#include <stdexcept>

namespace spanline::host {

// The command line asks for what cannot be: exit 2, where an InputError is exit 1.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace spanline::host
