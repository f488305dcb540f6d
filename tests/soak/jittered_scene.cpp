// jittered_scene SCENE SEED SIZE_M OUTPUT: writes the scene with its drawing moved here and there.
#include <cstdlib>
#include <span>

#include "commandline/tool.h"
#include "files/files.h"
#include "soak/jitter.h"

namespace ribbon {
namespace {

Result<ExitCode> write_jittered(std::span<char*> arguments) {
  if (arguments.size() != 4)
    return failure("", "four arguments are needed", "write SCENE SEED SIZE_M OUTPUT");
  const auto text = jittered_scene(arguments[0], std::strtoull(arguments[1], nullptr, 10),
                                   std::strtod(arguments[2], nullptr));
  if (!text) return tl::unexpected(text.error());
  if (auto written = write_file(arguments[3], *text); !written)
    return tl::unexpected(written.error());
  return ExitCode::done;
}

}  // namespace
}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::run_tool("jittered_scene", [&] {
    return ribbon::write_jittered({argv + 1, static_cast<std::size_t>(argc - 1)});
  });
}
