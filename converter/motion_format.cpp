#include "converter/motion_format.h"

#include <algorithm>
#include <array>
#include <string>

#include "commandline/extension.h"
#include "converter/export/alembic_writer.h"
#include "converter/export/fbx_writer.h"
#include "converter/export/mdd_writer.h"
#include "converter/export/npy_writer.h"
#include "converter/export/pc2_writer.h"
#include "converter/export/usd_writer.h"
#include "model/glb_writer.h"
#include "model/rate_warnings.h"

namespace ribbon {

namespace {

constexpr std::array<MotionFormat, 7> formats{{
    {".abc", new_alembic_writer, false, true, true, PicturePlace::nowhere, nullptr},
    {".fbx", new_fbx_writer, false, true, true, PicturePlace::beside, fbx_warning},
    {".glb", new_glb_writer, false, true, true, PicturePlace::inside, glb_warning},
    {".mdd", new_mdd_writer, true, true, false, PicturePlace::beside, rounded_time_warning},
    {".npy", new_npy_writer, false, false, false, PicturePlace::nowhere, nullptr},
    {".pc2", new_pc2_writer, true, false, false, PicturePlace::beside, nullptr},
    {".usda", new_usd_writer, false, true, true, PicturePlace::beside, nullptr},
}};

}  // namespace

std::span<const MotionFormat> motion_formats() {
  return formats;
}

const MotionFormat* motion_format(const std::filesystem::path& output) {
  const std::string extension = lower_case_extension(output);
  const auto* found = std::find_if(formats.begin(), formats.end(), [&](const MotionFormat& format) {
    return format.extension == extension;
  });
  return found == formats.end() ? nullptr : found;
}

}  // namespace ribbon
