// OSMesa is loaded when it is needed and not linked: it brings a compiler of more than a hundred
// megabytes along, which would be loaded for every look at a recording.
#include "player/preview/offscreen_context.h"

#include <GL/osmesa.h>
#include <dlfcn.h>

#include <array>
#include <cstdlib>
#include <string>
#include <utility>

namespace ribbon {

namespace {

constexpr const char* library_name = "libOSMesa.so.8";

// What OSMesa itself offers, beside OpenGL.
struct OsMesa {
  decltype(&OSMesaCreateContextAttribs) create_context = nullptr;
  decltype(&OSMesaDestroyContext) destroy_context = nullptr;
  decltype(&OSMesaMakeCurrent) make_current = nullptr;
  decltype(&OSMesaGetProcAddress) get_proc_address = nullptr;
};

template <class Function>
bool find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  return function != nullptr;
}

tl::unexpected<Error> no_osmesa(const std::string& problem) {
  return failure("--preview", problem,
                 "install OSMesa (Debian: libosmesa6), or render without --preview");
}

// Its names stay its own (RTLD_LOCAL), so that no other OpenGL of the process can answer for it. It
// is never unloaded: LLVM does not expect that.
Result<OsMesa> load_osmesa() {
  void* library = dlopen(library_name, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return no_osmesa(std::string("cannot load OSMesa: ") + dlerror());
  OsMesa osmesa;
  if (find(library, "OSMesaCreateContextAttribs", osmesa.create_context) &&
      find(library, "OSMesaDestroyContext", osmesa.destroy_context) &&
      find(library, "OSMesaMakeCurrent", osmesa.make_current) &&
      find(library, "OSMesaGetProcAddress", osmesa.get_proc_address))
    return osmesa;
  return no_osmesa(std::string(library_name) + " is too old");
}

// Mesa counts those that it starts, beside ours, which waits for them; 0: ours draws.
void limit_threads(int threads) {
  if (threads == 0) return;
  const std::string started = std::to_string(threads == 1 ? 0 : threads);
  setenv("LP_NUM_THREADS", started.c_str(), 1);
}

}  // namespace

struct OffscreenContext::State {
  explicit State(const OsMesa& functions) : osmesa(functions) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (context != nullptr) osmesa.destroy_context(context);
  }

  OsMesa osmesa;
  OSMesaContext context = nullptr;
  std::array<std::uint8_t, 4> pixel{};  // a context needs a buffer; pictures have their own
};

Result<OffscreenContext> OffscreenContext::create(int threads) {
  const auto osmesa = load_osmesa();
  if (!osmesa) return tl::unexpected(osmesa.error());
  limit_threads(threads);
  constexpr std::array attributes = {OSMESA_FORMAT,
                                     OSMESA_RGBA,
                                     OSMESA_DEPTH_BITS,
                                     0,
                                     OSMESA_PROFILE,
                                     OSMESA_CORE_PROFILE,
                                     OSMESA_CONTEXT_MAJOR_VERSION,
                                     3,
                                     OSMESA_CONTEXT_MINOR_VERSION,
                                     3,
                                     0};
  auto state = std::make_unique<State>(*osmesa);
  state->context = osmesa->create_context(attributes.data(), nullptr);
  if (state->context == nullptr ||
      osmesa->make_current(state->context, state->pixel.data(), GL_UNSIGNED_BYTE, 1, 1) == 0)
    return no_osmesa("OSMesa cannot draw OpenGL 3.3");
  return OffscreenContext(std::move(state));
}

OffscreenContext::OffscreenContext(std::unique_ptr<State> state) : state_(std::move(state)) {}
OffscreenContext::OffscreenContext(OffscreenContext&&) noexcept = default;
OffscreenContext& OffscreenContext::operator=(OffscreenContext&&) noexcept = default;
OffscreenContext::~OffscreenContext() = default;

void OffscreenContext::make_current() const {
  state_->osmesa.make_current(state_->context, state_->pixel.data(), GL_UNSIGNED_BYTE, 1, 1);
}

OffscreenContext::Function OffscreenContext::function(const char* name) const {
  return state_->osmesa.get_proc_address(name);
}

}  // namespace ribbon
