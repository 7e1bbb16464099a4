#include "viewer/window/osmesa.h"

#include <cstdint>
#include <type_traits>
#include <vector>

#include <GL/osmesa.h>
#include <dlfcn.h>
#include <fmt/format.h>

namespace glint {
namespace {

struct OsMesa {
    decltype(&OSMesaCreateContextAttribs) createContext = nullptr;
    decltype(&OSMesaMakeCurrent) makeCurrent = nullptr;
    decltype(&OSMesaDestroyContext) destroyContext = nullptr;
    decltype(&OSMesaGetProcAddress) getProcAddress = nullptr;
};

Result<OsMesa> openOsMesa() {
    void* library = dlopen(kOsMesaLibrary, RTLD_LAZY | RTLD_LOCAL);
    if (library == nullptr) {
        return Error{fmt::format("cannot draw without a display: {} (package libosmesa6)", dlerror()), {}};
    }
    OsMesa api;
    const auto find = [library](const char* name, auto& function) {
        function = reinterpret_cast<std::decay_t<decltype(function)>>(dlsym(library, name));
        return function != nullptr;
    };
    if (!find("OSMesaCreateContextAttribs", api.createContext) ||
        !find("OSMesaMakeCurrent", api.makeCurrent) || !find("OSMesaDestroyContext", api.destroyContext) ||
        !find("OSMesaGetProcAddress", api.getProcAddress)) {
        return Error{fmt::format("cannot draw without a display: {} is too old", kOsMesaLibrary), {}};
    }
    return api;
}

class Context final : public OsMesaContext {
  public:
    explicit Context(const OsMesa& api) : api_(api) {}
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    ~Context() override {
        if (context_ != nullptr) { api_.destroyContext(context_); }
    }

    bool open(int width, int height) {
        const int attributes[] = {OSMESA_FORMAT,
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
        context_ = api_.createContext(attributes, nullptr);
        pixels_.resize(static_cast<size_t>(width) * static_cast<size_t>(height) * 4);
        return context_ != nullptr &&
               api_.makeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, width, height);
    }

    Proc (*lookup() const)(const char*) override { return api_.getProcAddress; }

  private:
    OsMesa api_;
    OSMesaContext context_ = nullptr;
    std::vector<uint8_t> pixels_;
};

}  // namespace

Result<std::unique_ptr<OsMesaContext>> OsMesaContext::create(int width, int height) {
    const auto api = openOsMesa();
    if (!api) { return api.error(); }
    auto context = std::make_unique<Context>(*api);
    if (!context->open(width, height)) {
        return Error{fmt::format("{} refuses an OpenGL 3.3 context of {}x{}", kOsMesaLibrary, width, height),
                     {}};
    }
    return std::unique_ptr<OsMesaContext>(std::move(context));
}

}  // namespace glint
