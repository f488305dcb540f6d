// ribbon-play in a folder with a small recording.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "commandline/tool_run.h"
#include "files/files.h"
#include "files/flipped.h"
#include "recording/sample_recording.h"

namespace ribbon {

class RibbonPlay : public ToolTest {
 protected:
  RibbonPlay() : ToolTest(RIBBON_PLAY) { write_sample_recording(recording_, 7); }

  [[nodiscard]] ToolRun play_small(const std::string& arguments,
                                   const std::string& before = "") const {
    return run("knot.rbn --size 64x48 --samples 1 " + arguments, before);
  }

  void damage() const {
    ASSERT_TRUE(write_file(recording_,
                           flipped(bytes("knot.rbn"), std::filesystem::file_size(recording_) / 2)));
  }

  // What lies in a folder below, but for lists of what is complete.
  [[nodiscard]] std::set<std::string> pictures(const std::string& below) const {
    std::set<std::string> pictures = names(below);
    std::erase_if(pictures, [](const std::string& name) { return name.ends_with(".txt"); });
    return pictures;
  }

  std::filesystem::path recording_ = folder_ / "knot.rbn";
};

}  // namespace ribbon
