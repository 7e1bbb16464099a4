// OpenEXR reports everything by exceptions; each entry point here turns them into an Error.
#include "engine/io/exr_io.h"

#include <cmath>
#include <cstring>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>
#include <half.h>

#include "engine/io/atomic_file.h"
#include "engine/io/image_io.h"
#include "engine/math/vec.h"

namespace glint {
namespace {

/// Longest side that is read: what OpenEXR allocates for a picture's line table grows with it.
constexpr int kMaxExrSide = 1 << 24;
constexpr float kLargestHalf = 65504.0f;

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

std::map<std::string, std::string> textAttributes(const Imf::Header& header) {
    std::map<std::string, std::string> out;
    for (auto it = header.begin(); it != header.end(); ++it) {
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute())) {
            out[it.name()] = text->value();
        }
    }
    return out;
}

Result<ExrImage> readRgbImage(Imf::InputFile& file, const std::string& path) {
    const Imath::Box2i window = file.header().dataWindow();
    const int64_t width = int64_t{window.max.x} - window.min.x + 1;
    const int64_t height = int64_t{window.max.y} - window.min.y + 1;
    if (width <= 0 || height <= 0 || width > kMaxExrSide || height > kMaxExrSide ||
        static_cast<uint64_t>(width * height) > kMaxImagePixels) {
        return exrError(path, fmt::format("the data window is {} x {}; expected between 1 and {} pixels",
                                          width, height, kMaxImagePixels));
    }
    ExrImage image{.width = static_cast<int>(width),
                   .height = static_cast<int>(height),
                   .channels = {},
                   .attributes = textAttributes(file.header())};
    const Imf::ChannelList& list = file.header().channels();
    for (auto it = list.begin(); it != list.end(); ++it) {
        if (it.channel().xSampling != 1 || it.channel().ySampling != 1) {
            continue;  // chroma at half resolution: luminance/chroma files are read as grey, by Y
        }
        const bool isId = it.channel().type == Imf::UINT;
        ExrChannel channel{
            .name = it.name(),
            .type = isId ? ExrPixelType::Uint
                         : (it.channel().type == Imf::HALF ? ExrPixelType::Half : ExrPixelType::Float),
            .floats = {},
            .ids = {}};
        const size_t count = static_cast<size_t>(width * height);
        isId ? channel.ids.resize(count) : channel.floats.resize(count);
        image.channels.push_back(std::move(channel));
    }
    Imf::FrameBuffer frame;
    for (ExrChannel& channel : image.channels) {
        const bool isId = channel.type == ExrPixelType::Uint;
        frame.insert(channel.name, isId ? sliceOver(channel.ids.data(), Imf::UINT, window)
                                        : sliceOver(channel.floats.data(), Imf::FLOAT, window));
    }
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    return image;
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

Result<ExrImage> decodeExr(std::string_view bytes, const std::string& path) {
    if (!looksLikeExr(bytes)) {
        return exrError(path, "is not an OpenEXR file (its first four bytes are wrong)");
    }
    try {
        Imf::Header::setMaxImageSize(kMaxExrSide, kMaxExrSide);
        MemoryInput stream(bytes, path);
        Imf::InputFile file(stream, 1);
        return readRgbImage(file, path);
    } catch (const std::exception& problem) {
        return exrError(path, fmt::format("is a broken or unsupported OpenEXR file: {}", problem.what()));
    }
}

Result<ExrImage> loadExr(const std::string& path) {
    const Result<std::string> bytes = readFile(path);
    if (!bytes) { return bytes.error(); }
    return decodeExr(*bytes, path);
}

Result<ImageF> exrColor(const ExrImage& exr, const std::string& path) {
    const ExrChannel* grey = exr.find("Y");
    const ExrChannel* channels[3] = {exr.find("R"), exr.find("G"), exr.find("B")};
    for (const ExrChannel*& channel : channels) {
        channel = channel != nullptr ? channel : grey;
        if (channel == nullptr || channel->type == ExrPixelType::Uint) {
            return exrError(path, "has no colour; expected the channels R, G and B, or Y");
        }
    }
    ImageF image{.width = exr.width, .height = exr.height, .rgb = {}};
    image.rgb.resize(3 * channels[0]->floats.size());
    for (size_t c = 0; c < 3; ++c) {
        for (size_t i = 0; i < channels[c]->floats.size(); ++i) {
            const float value = channels[c]->floats[i];
            if (!std::isfinite(value)) {
                const size_t width = static_cast<size_t>(exr.width);
                return exrError(path,
                                fmt::format("the pixel in column {}, row {} is {}; expected finite numbers",
                                            i % width, i / width, value));
            }
            image.rgb[3 * i + c] = value;
        }
    }
    return image;
}

Status saveExr(const std::string& path, const ExrImage& image) {
    if (Status whole = checkToSave(image, path); !whole) { return whole; }
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
        {
            Imf::OutputFile file(stream, header, 1);  // its destructor writes the line table
            file.setFrameBuffer(buffers.frame);
            file.writePixels(image.height);
        }
        return writeFileAtomically(path, stream.bytes());
    } catch (const std::exception& problem) {
        return exrError(path, fmt::format("cannot make the OpenEXR file: {}", problem.what()));
    }
}

}  // namespace glint
