// Arrays of numbers in FBX files, deflated.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>

#include "converter/export/fbx_record.h"
#include "model/raw_bytes.h"

namespace ribbon {

// Keeps its working memory between calls. Equal numbers give equal bytes.
class FbxArrays {
 public:
  FbxArrays();
  FbxArrays(FbxArrays&&) noexcept;
  FbxArrays& operator=(FbxArrays&&) = delete;
  ~FbxArrays();

  // Column after column.
  template <class Derived>
  FbxProperty array(const Eigen::PlainObjectBase<Derived>& numbers) {
    return deflated(letter(typename Derived::Scalar{}), static_cast<std::size_t>(numbers.size()),
                    raw_bytes(numbers));
  }

 private:
  struct State;

  // FBX's names for types.
  static constexpr char letter(double) { return 'd'; }
  static constexpr char letter(float) { return 'f'; }
  static constexpr char letter(std::int64_t) { return 'l'; }
  static constexpr char letter(std::int32_t) { return 'i'; }

  FbxProperty deflated(char type, std::size_t elements, std::string_view bytes);

  std::unique_ptr<State> state_;
};

}  // namespace ribbon
