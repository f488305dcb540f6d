// Alembic, as docs/export.md lays it out.
#pragma once

#include <filesystem>
#include <memory>

#include "converter/read_back/written_motion.h"

namespace ribbon {

// Every object below the top one holds one mesh, whose positions alone may move. Throws Spoiled.
std::unique_ptr<WrittenMotion> read_alembic(const std::filesystem::path& path);

}  // namespace ribbon
