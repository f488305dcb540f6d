// What records of objects in FBX are made of: identities, names, connections.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "converter/export/fbx_record.h"

namespace ribbon {

// What has an identity of its own.
enum class FbxKind : std::int64_t {
  geometry = 1,
  node,
  material,
  deformer,
  shape,
  channel,
  curve,
  curve_node,
  layer,
  stack,
  texture,
  video
};

inline std::int64_t fbx_identity(FbxKind kind, int index = 0) {
  return (static_cast<std::int64_t>(kind) << 32) + index;
}

// A name as FBX writes it, with its class behind it.
inline std::string fbx_name(std::string_view name, std::string_view name_class) {
  return std::string(name).append("\0\1", 2).append(name_class);
}

inline FbxRecord fbx_connection(std::int64_t from, std::int64_t to) {
  return {"C", {"OO", from, to}};
}

inline FbxRecord fbx_connection(std::int64_t from, std::int64_t to, std::string_view property) {
  return {"C", {"OP", from, to, property}};
}

}  // namespace ribbon
