#include "converter/encode_model.h"

#include "converter/export/fbx_writer.h"
#include "model/obj_text.h"

namespace ribbon {

Result<std::string> encode_model(OutputFormat format, const Model& model,
                                 const std::string& library) {
  if (format == OutputFormat::fbx) return fbx_bytes(model);
  return obj_text(model, library);
}

}  // namespace ribbon
