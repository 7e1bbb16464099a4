#include "engine/io/exr_classic.h"

#include <cstring>
#include <mutex>

#include <ImfFrameBuffer.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfThreading.h>
#include <fmt/format.h>
#include <malloc.h>

#include "engine/io/image_builder.h"

namespace glint {
namespace {

class MemoryInput : public Imf::IStream {
  public:
    MemoryInput(std::string_view bytes, const std::string& name) : IStream(name.c_str()), bytes_(bytes) {}

    bool read(char out[], int count) override {
        if (count < 0 || static_cast<uint64_t>(count) > bytes_.size() - position_) {
            throw std::runtime_error("the file ends too early");
        }
        std::memcpy(out, bytes_.data() + position_, static_cast<size_t>(count));
        position_ += static_cast<size_t>(count);
        return position_ < bytes_.size();
    }
    uint64_t tellg() override { return position_; }
    void seekg(uint64_t position) override {
        if (position > bytes_.size()) { throw std::runtime_error("the file ends too early"); }
        position_ = static_cast<size_t>(position);
    }

  private:
    std::string_view bytes_;
    size_t position_ = 0;
};

/// Over a target whose first value is that of the window's first pixel.
Imf::Slice sliceOver(const ExrTarget& target, const ExrPartChannel& channel, const ExrWindow& window) {
    const auto rowLength = static_cast<size_t>((window.width() + channel.xSampling - 1) / channel.xSampling);
    return Imf::Slice::Make(channel.type == ExrPixelType::Uint ? Imf::UINT : Imf::FLOAT, target.values,
                            Imath::V2i(window.minX, window.minY), window.width(), window.height(),
                            target.stride, target.stride * rowLength, channel.xSampling, channel.ySampling);
}

/// While one lives, the C library hands out zeros: OpenEXR's DWA leaves buffers unset where a chunk is
/// damaged, and copies them to the picture. Blocks of up to a kilobyte that this thread has freed before are
/// handed out as they are.
class ZeroedMemory {
  public:
    ZeroedMemory() : lock_(mutex()) { ::mallopt(M_PERTURB, 0xff); }
    ~ZeroedMemory() { ::mallopt(M_PERTURB, 0); }
    ZeroedMemory(const ZeroedMemory&) = delete;
    ZeroedMemory& operator=(const ZeroedMemory&) = delete;

  private:
    static std::mutex& mutex() {
        static std::mutex one;
        return one;
    }
    std::scoped_lock<std::mutex> lock_;
};

}  // namespace

Status readByClassicLibrary(std::string_view bytes, const std::string& path, const ExrPart& part,
                            std::span<const ExrTarget> targets) {
    const ZeroedMemory zeroed;
    try {
        MemoryInput stream(bytes, path);
        Imf::setGlobalThreadCount(
            0);  // its pool, made at the first task, waits for ever where memory runs short
        Imf::MultiPartInputFile file(stream, 1);
        Imf::InputPart input(file, part.index);
        Imf::FrameBuffer frame;
        for (const ExrTarget& target : targets) {
            const ExrPartChannel& channel = part.channels[target.channel];
            frame.insert(channel.name, sliceOver(target, channel, part.data));
        }
        input.setFrameBuffer(frame);
        input.readPixels(part.data.minY, part.data.maxY);
        return {};
    } catch (const std::exception& problem) {
        return imageError(path, fmt::format("is a broken or unsupported OpenEXR file: {}", problem.what()));
    }
}

}  // namespace glint
