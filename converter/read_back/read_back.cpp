#include "converter/read_back/read_back.h"

#include <algorithm>
#include <array>

#include "converter/read_back/alembic_file.h"
#include "converter/read_back/fbx_file.h"
#include "converter/read_back/glb_file.h"
#include "converter/read_back/obj_file.h"
#include "converter/read_back/point_caches.h"
#include "converter/read_back/usd_file.h"

namespace ribbon {

namespace {

constexpr const char* own = "a reader of its own";

constexpr std::array<FileReader, 8> readers{{
    {".abc", read_alembic, own},
    {".fbx", read_fbx_file, own},
    {".glb", read_glb, own},
    {".mdd", read_mdd, own},
    {".npy", read_npy, own},
    {".obj", read_obj, "tinyobjloader"},
    {".pc2", read_pc2, own},
    {".usda", read_usd, own},
}};

}  // namespace

const FileReader* file_reader(std::string_view extension) {
  const auto* found = std::find_if(readers.begin(), readers.end(), [&](const FileReader& reader) {
    return reader.extension == extension;
  });
  return found == readers.end() ? nullptr : found;
}

}  // namespace ribbon
