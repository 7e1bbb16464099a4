// A surface in memory, for machines without a display and for tests.

#include <algorithm>
#include <chrono>
#include <thread>

#include <imgui.h>

#include "viewer/window/gl_lookup.h"
#include "viewer/window/key_codes.h"
#include "viewer/window/osmesa.h"
#include "viewer/window/surface.h"

namespace glint {
namespace {

class HeadlessSurface final : public Surface {
  public:
    HeadlessSurface(const SurfaceOptions& options, std::unique_ptr<OsMesaContext> context, const GlApi& gl)
        : size_(options.width, options.height),
          contentScale_(options.contentScale > 0.0f ? options.contentScale : 1.0f),
          context_(std::move(context)),
          gl_(gl) {
        setHeadlessLookup(kOsMesaLibrary, context_->lookup());
    }
    HeadlessSurface(const HeadlessSurface&) = delete;
    HeadlessSurface& operator=(const HeadlessSurface&) = delete;
    ~HeadlessSurface() override { setHeadlessLookup(nullptr, nullptr); }

    const GlApi& gl() const override { return gl_; }

    void waitEvents(double seconds) override {
        std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    }

    void beginFrame() override {
        ImGuiIO& io = ImGui::GetIO();
        setKeyMap(&io);
        const auto now = std::chrono::steady_clock::now();
        io.DisplaySize = {static_cast<float>(size_.x), static_cast<float>(size_.y)};
        io.DeltaTime = std::max(1e-4f, std::chrono::duration<float>(now - lastFrame_).count());
        lastFrame_ = now;
    }

    void present() override { gl_.Finish(); }
    bool shouldClose() const override { return false; }
    void refuseClose() override {}
    bool takeInputFlag() override { return false; }
    std::vector<std::string> takeDroppedFiles() override { return {}; }
    Vec2i framebufferSize() const override { return size_; }
    float contentScale() const override { return contentScale_; }
    float framebufferScale() const override { return 1.0f; }
    void setTitle(const std::string&) override {}
    bool hasDisplay() const override { return false; }

  private:
    Vec2i size_;
    float contentScale_;
    std::unique_ptr<OsMesaContext> context_;
    GlApi gl_;
    std::chrono::steady_clock::time_point lastFrame_ = std::chrono::steady_clock::now();
};

}  // namespace

Result<std::unique_ptr<Surface>> makeHeadlessSurface(const SurfaceOptions& options) {
    auto context = OsMesaContext::create(options.width, options.height);
    if (!context) { return context.error(); }
    const auto gl = loadGlApi((*context)->lookup());
    if (!gl) { return gl.error(); }
    return std::unique_ptr<Surface>(std::make_unique<HeadlessSurface>(options, std::move(*context), *gl));
}

}  // namespace glint
