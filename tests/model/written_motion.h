// All frames of a sample in one file.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "files/files.h"
#include "files/temporary_folder.h"
#include "model/motion_writer.h"
#include "model/posed_model.h"

namespace ribbon {

using NewMotionWriter = std::function<Result<std::unique_ptr<MotionWriter>>(
    const std::filesystem::path& path, const Model& model, int frames)>;

// The bytes of the file.
inline std::string written_motion(const NewMotionWriter& new_writer, const SampleKnot& knot,
                                  const ModelSettings& settings = {}) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a";
  const auto writer =
      new_writer(path, posed_model(knot, 0, settings), static_cast<int>(knot.frames.size()))
          .value();
  for (std::size_t frame = 0; frame < knot.frames.size(); ++frame)
    EXPECT_TRUE(writer->append(posed_model(knot, frame, settings)));
  EXPECT_FALSE(std::filesystem::exists(path)) << "the file must not appear before it is complete";
  EXPECT_TRUE(writer->finish());
  return read_file(path).value();
}

}  // namespace ribbon
