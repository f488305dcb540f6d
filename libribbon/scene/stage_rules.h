// What the stages of a scene have to agree in, beyond the kinds of their values.
#pragma once

#include "result/result.h"
#include "scene/document.h"
#include "scene/scene.h"

namespace ribbon {

// Fails, with the place, where a stage has no hands or can never end, where hands do not know what
// to do or fight over the same part of the band, and where nothing tells their force.
Result<void> check_stages(const Document& document, const Scene& scene);

}  // namespace ribbon
