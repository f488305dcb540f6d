// Whatever the text of a scene, it is read or refused with a sentence.
#include <string>

#include "fuzz/must.h"
#include "scene/scene.h"

// libFuzzer gives the name. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ribbon;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto scene = read_scene("fuzz.toml", text);
  if (!scene) {
    must(!scene.error().sentence().empty(), "a refusal says why");
    return 0;
  }
  must(scene->text == text, "a scene keeps its text");
  const auto again = read_scene("fuzz.toml", text);
  must(again && *again == *scene, "the same text gives the same scene");
  return 0;
}
