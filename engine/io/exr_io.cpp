// OpenEXR reports everything by exceptions; saving turns them into an Error.
#include "engine/io/exr_io.h"

#include <cmath>
#include <cstring>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>
#include <fmt/format.h>
#include <half.h>

#include "engine/io/atomic_file.h"
#include "engine/io/exr_file.h"
#include "engine/math/vec.h"

namespace glint {
namespace {

class MemoryOutput : public Imf::OStream {
  public:
    explicit MemoryOutput(const std::string& name) : OStream(name.c_str()) {}

    void write(const char data[], int count) override {
        const size_t size = static_cast<size_t>(count);
        bytes_.resize(std::max(bytes_.size(), position_ + size));
        std::memcpy(bytes_.data() + position_, data, size);
        position_ += size;
    }
    uint64_t tellp() override { return position_; }
    void seekp(uint64_t position) override { position_ = static_cast<size_t>(position); }

    const std::string& bytes() const { return bytes_; }

  private:
    std::string bytes_;
    size_t position_ = 0;
};

Error exrError(const std::string& path, std::string message) { return {std::move(message), {.file = path}}; }

Imf::PixelType imfType(ExrPixelType type) {
    switch (type) {
        case ExrPixelType::Half:
            return Imf::HALF;
        case ExrPixelType::Float:
            return Imf::FLOAT;
        case ExrPixelType::Uint:
            return Imf::UINT;
    }
    return Imf::FLOAT;
}

/// A slice over one channel's values. `first` is where the data window's first pixel lies.
Imf::Slice sliceOver(void* values, Imf::PixelType type, const Imath::Box2i& window) {
    const size_t width = static_cast<size_t>(window.max.x - window.min.x) + 1;
    const size_t size = type == Imf::HALF ? 2 : 4;
    return Imf::Slice::Make(type, values, window.min, static_cast<int64_t>(width),
                            window.max.y - window.min.y + 1, size, size * width);
}

/// What OpenEXR reads while the file is written. Half values are converted here, since it does not convert
/// on output.
struct OutputBuffers {
    std::vector<std::vector<half>> halves;
    Imf::FrameBuffer frame;
};

void addChannel(const ExrChannel& channel, const Imath::Box2i& window, OutputBuffers* buffers) {
    void* values = nullptr;
    if (channel.type == ExrPixelType::Half) {
        std::vector<half>& halves = buffers->halves.emplace_back();
        halves.reserve(channel.floats.size());
        for (const float value : channel.floats) {
            halves.emplace_back(std::isinf(value) ? value : clampf(value, -kLargestHalf, kLargestHalf));
        }
        values = buffers->halves.back().data();
    } else if (channel.type == ExrPixelType::Float) {
        values = const_cast<float*>(
            channel.floats.data());  // Slice is shared by reading and writing; this one reads
    } else {
        values = const_cast<uint32_t*>(channel.ids.data());
    }
    buffers->frame.insert(channel.name, sliceOver(values, imfType(channel.type), window));
}

Status checkToSave(const ExrImage& image, const std::string& path) {
    if (image.width <= 0 || image.height <= 0 || image.channels.empty()) {
        return exrError(path, "there is no picture to save");
    }
    const size_t pixels = static_cast<size_t>(image.width) * static_cast<size_t>(image.height);
    for (const ExrChannel& channel : image.channels) {
        const size_t count = channel.type == ExrPixelType::Uint ? channel.ids.size() : channel.floats.size();
        if (count != pixels || channel.name.empty()) {
            return exrError(path, fmt::format("channel \"{}\" has {} values; expected a name and {} values",
                                              channel.name, count, pixels));
        }
    }
    return {};
}

}  // namespace

const ExrChannel* ExrImage::find(std::string_view name) const {
    for (const ExrChannel& channel : channels) {
        if (channel.name == name) { return &channel; }
    }
    return nullptr;
}

bool looksLikeExr(std::string_view bytes) { return bytes.starts_with("\x76\x2f\x31\x01"); }

Result<ExrImage> decodeExr(std::string_view bytes, const std::string& path,
                           const std::function<bool(std::string_view name)>& wanted) {
    Result<ExrFile> file = ExrFile::open(bytes, path);
    if (!file) { return file.error(); }
    const ExrPart& part = file->parts().front();
    ExrImage image{.width = static_cast<int>(part.data.width()),
                   .height = static_cast<int>(part.data.height()),
                   .channels = {},
                   .attributes = part.attributes};
    const size_t count = static_cast<size_t>(image.width) * static_cast<size_t>(image.height);
    std::vector<ExrTarget> targets;
    for (size_t i = 0; i < part.channels.size(); ++i) {
        const ExrPartChannel& info = part.channels[i];
        if (info.xSampling != 1 || info.ySampling != 1 || !wanted(info.name)) { continue; }
        ExrChannel& channel = image.channels.emplace_back(ExrChannel{info.name, info.type, {}, {}});
        const bool isId = info.type == ExrPixelType::Uint;
        isId ? channel.ids.resize(count) : channel.floats.resize(count);
        void* values = isId ? static_cast<void*>(channel.ids.data()) : channel.floats.data();
        targets.push_back({.channel = i, .values = values});
    }
    if (Status read = file->read(part, targets); !read) { return read.error(); }
    return image;
}

Result<ExrImage> loadExr(const std::string& path) {
    const Result<std::string> bytes = readFile(path);
    if (!bytes) { return bytes.error(); }
    return decodeExr(*bytes, path);
}

Result<std::string> encodeExr(const ExrImage& image, const std::string& path) {
    if (Status whole = checkToSave(image, path); !whole) { return whole.error(); }
    try {
        Imf::Header header(image.width, image.height);
        header.compression() = Imf::ZIP_COMPRESSION;
        for (const auto& [name, text] : image.attributes) {
            header.insert(name, Imf::StringAttribute(text));
        }
        OutputBuffers buffers;
        for (const ExrChannel& channel : image.channels) {
            header.channels().insert(channel.name, Imf::Channel(imfType(channel.type)));
            addChannel(channel, header.dataWindow(), &buffers);
        }
        MemoryOutput stream(path);
        // OpenEXR makes its pool of threads at the first task, and where memory runs short there waits
        // for ever.
        Imf::setGlobalThreadCount(0);
        {
            Imf::OutputFile file(stream, header, 1);  // its destructor writes the line table
            file.setFrameBuffer(buffers.frame);
            file.writePixels(image.height);
        }
        return stream.bytes();
    } catch (const std::exception& problem) {
        return exrError(path, fmt::format("cannot make the OpenEXR file: {}", problem.what()));
    }
}

Status saveExr(const std::string& path, const ExrImage& image) {
    const Result<std::string> bytes = encodeExr(image, path);
    return bytes ? writeFileAtomically(path, *bytes) : Status(bytes.error());
}

}  // namespace glint
