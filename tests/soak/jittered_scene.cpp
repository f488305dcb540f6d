// jittered_scene SCENE SEED SIZE_M OUTPUT: writes the scene with its drawing moved here and there.
#include <cstdio>
#include <cstdlib>

#include "files/files.h"
#include "result/demanded.h"
#include "soak/jitter.h"

int main(int argc, char** argv) {
  using namespace ribbon;
  if (argc != 5) {
    std::fputs("usage: jittered_scene SCENE SEED SIZE_M OUTPUT\n", stderr);
    return 2;
  }
  const auto seed = std::strtoull(argv[2], nullptr, 10);
  const double size_m = std::strtod(argv[3], nullptr);
  demanded(write_file(argv[4], demanded(jittered_scene(argv[1], seed, size_m))));
}
