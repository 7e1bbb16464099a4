// An OpenEXR file in memory: what its headers state, and the values of chosen channels.
//
// Reads through OpenEXR's C library, which checks what chunks unpack to and takes its memory from us: bytes
// that a damaged file leaves out are 0. Which channels make a picture is decided in exr_color.cpp. Internal
// to engine/io.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/io/exr_io.h"
#include "engine/math/vec.h"

namespace glint {

/// Pixels from min to max, both inside.
struct ExrWindow {
    int minX = 0, minY = 0, maxX = -1, maxY = -1;

    int64_t width() const { return int64_t{maxX} - minX + 1; }
    int64_t height() const { return int64_t{maxY} - minY + 1; }
    bool operator==(const ExrWindow&) const = default;
};

struct ExrPartChannel {
    std::string name;
    ExrPixelType type = ExrPixelType::Half;
    int xSampling = 1, ySampling = 1;  ///< a value for so many columns and rows
};

struct ExrPart {
    int index = 0;
    bool isTiled = false;
    bool needsClassicLibrary = false;  ///< packed by DWA, or B44 with more than halves
    ExrWindow data, display;
    std::vector<ExrPartChannel> channels;
    std::optional<std::array<Vec2, 4>> chromaticities;  ///< of red, green, blue and white: CIE x, y
    std::map<std::string, std::string> attributes;      ///< the text attributes
};

/// Where the values of a channel go: Half and Float as floats, Uint as they are.
struct ExrTarget {
    size_t channel = 0;
    void* values = nullptr;  ///< of the data window's first pixel
    size_t stride = 4;       ///< bytes from one value to the next; rows follow each other
};

class ExrFile {
  public:
    /// `bytes` must outlive it. Error: not an OpenEXR file, broken, more pixels than kMaxImagePixels or than
    /// its size allows. Deep parts are left out.
    static Result<ExrFile> open(std::string_view bytes, const std::string& path);

    const std::vector<ExrPart>& parts() const { return parts_; }
    /// Error: broken or cut off.
    Status read(const ExrPart& part, std::span<const ExrTarget> targets);

  private:
    struct Context;
    struct CloseContext {
        void operator()(Context* context) const;
    };

    ExrFile() = default;
    Error broken() const;
    /// Lists the part, unless it is deep.
    Status addPart(int index, uint64_t fileSize);

    std::string path_;
    std::unique_ptr<Context, CloseContext> context_;
    std::vector<ExrPart> parts_;
};

}  // namespace glint
