// pack_scenes NEW SCENE...: the scenes that a page offers, as one list (scene_json()).
#include <string>

#include "commandline/tool.h"
#include "files/files.h"
#include "recorder/page/scene_json.h"

namespace ribbon {

namespace {

Result<ExitCode> pack(const std::string& target, int count, char** scenes) {
  Json list = Json::list({});
  for (int i = 0; i < count; ++i) {
    auto json = read_scene(scenes[i]).and_then(scene_json);
    if (!json) return tl::unexpected(json.error());
    list.add(*std::move(json));
  }
  return write_file(target, list.line()).map([] { return ExitCode::done; });
}

}  // namespace

}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::run_tool("pack_scenes", [&]() -> ribbon::Result<ribbon::ExitCode> {
    if (argc < 3)
      return ribbon::failure("", "needs at least two names", "pack_scenes NEW SCENE...");
    return ribbon::pack(argv[1], argc - 2, argv + 2);
  });
}
