#include "sim/verb.hpp"

#include <CLI/CLI.hpp>

namespace spanline::host {

bool Verb::chosen() const { return verb_->parsed(); }

}  // namespace spanline::host
