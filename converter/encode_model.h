// A model as the bytes of a file.
#pragma once

#include <string>

#include "converter/output_format.h"
#include "model/model.h"
#include "result/result.h"

namespace ribbon {

// In a format that holds one frame a file. `library` is the material library that OBJ refers to.
Result<std::string> encode_model(OutputFormat format, const Model& model,
                                 const std::string& library);

}  // namespace ribbon
