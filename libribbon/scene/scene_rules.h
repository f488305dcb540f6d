// What a scene has to agree in, beyond the kinds of its values, and what it need not say.
#pragma once

#include "result/result.h"
#include "scene/document.h"
#include "scene/scene.h"

namespace ribbon {

// What the scene leaves out and other keys tell: rates, clearance, what hands do not say
// themselves. Steps are shortened so far that each frame falls on one.
void set_defaults(const Document& document, Scene& scene);

// Fails, with the place, where two keys contradict each other or one lacks the other.
Result<void> check_rules(const Document& document, const Scene& scene);

}  // namespace ribbon
