#include <exception>
#include <iostream>

#include "page.hpp"
#include "sim/output_file.hpp"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: spanline-figures FOLDER PAGE.md    (assets/watkins docs/figure-33.md)\n";
    return 2;
  }
  try {
    using namespace spanline::figures;
    spanline::host::write_file(argv[2], figure_page(measure_all(argv[1])));
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "spanline-figures: " << error.what() << "\n";
    return 1;
  }
}
