// spanline-meshgen PATCHES.bpt FOLDER: writes the meshes of assets/ into FOLDER, byte for byte as they are kept there.
#include <cstdio>
#include <exception>
#include <fstream>

#include "shapes.hpp"

namespace {

using spanline::make::Mesh;

template <typename Write>
void save_file(const std::string& path, const Write& write) {
  std::ofstream out(path, std::ios::binary);
  write(out);
  out.close();
  if (!out) throw std::runtime_error("cannot write " + path);
}

void save(const std::string& folder, const std::string& name, const Mesh& mesh, const std::string& comment,
          const std::string& mtl = "") {
  save_file(folder + "/" + name, [&](std::ostream& out) { mesh.write(out, comment, mtl); });
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 3) {
    std::fputs("usage: spanline-meshgen PATCHES.bpt FOLDER\n", stderr);
    return 2;
  }
  namespace make = spanline::make;
  const std::string patches = argv[1];
  const std::string folder = argv[2];
  save(folder, "teapot.obj", make::dice_patches(patches, 4, true),
       "Newell's teapot, each patch diced into 4 x 4 x 2 triangles");
  save(folder, "teapot_fine.obj", make::dice_patches(patches, 6, false),
       "Newell's teapot, each patch diced into 6 x 6 quads");
  save_file(folder + "/teapot_seed.bpt", [&](std::ostream& out) { make::write_seed_teapot(patches, out); });
  save(folder, "gear20.obj", make::gear(20, 5), "A gear of 20 teeth");
  save(folder, "gear12.obj", make::gear(12, 4), "A gear of 12 teeth that meshes with gear20.obj");
  save(folder, "gauge_rim.obj", make::gauge_rim(), "The rim of a round gauge");
  save(folder, "gauge_dial.obj", make::gauge_dial(), "The dial of a round gauge");
  save(folder, "gauge_scale.obj", make::gauge_scale(), "The scale of a round gauge", "gauge_scale.mtl");
  save(folder, "gauge_needle.obj", make::gauge_needle(), "The needle of a round gauge");
  save(folder, "torus.obj", make::torus(25, 20), "A ring of 1,000 triangles, closed");
  save(folder, "torus_knot.obj", make::torus_knot(96, 10), "A tube along the (2, 3) torus knot");
  save(folder, "letters.obj", make::letters(), "The word SPAN; a bridge edge joins each hole to its outline");
  save(folder, "cubes.obj", make::penetrating_cubes(), "Three cubes through one another", "cubes.mtl");
  save(folder, "floor.obj", make::checkered_floor(8), "A checkered floor", "floor.mtl");
  save(folder, "die_ivory.obj", make::die("ivory", "ink"), "A die; its pips lie on its sides", "dice.mtl");
  save(folder, "die_red.obj", make::die("red", "chalk"), "The same in red", "dice.mtl");
  save(folder, "house.obj", make::house(), "A house on its lawn; windows, door and path lie on other faces",
       "house.mtl");
  save(folder, "landscape.obj", make::landscape(24), "Hills round a lake", "landscape.mtl");
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "spanline-meshgen: %s\n", error.what());
  return 1;
}
