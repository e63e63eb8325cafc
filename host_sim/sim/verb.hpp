#pragma once

#include "sim/cli_app.hpp"

namespace spanline::host {

// What all verbs of a command line have.
class Verb {
 public:
  // Whether the command line names it; once that has been parsed.
  bool chosen() const;

 protected:
  // `verb`: a subcommand, which lives as long as its App.
  explicit Verb(CLI::App* verb) : verb_(verb) {}

  CLI::App* verb_;
};

}  // namespace spanline::host
