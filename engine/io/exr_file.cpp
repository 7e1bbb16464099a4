#include "engine/io/exr_file.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>
#include <openexr.h>

#include "engine/io/exr_classic.h"
#include "engine/io/image_builder.h"
#include "engine/io/image_io.h"

namespace glint {
namespace {

/// Longest side that is read: the line table grows with it.
constexpr int kMaxSide = 1 << 24;
/// Deflate reaches 1032 : 1, and so do no runs and no Huffman codes of OpenEXR. DWA packs 64 values into
/// one first.
constexpr double kMostPacked = 1032.0;
constexpr double kMostPackedByDwa = 64.0 * kMostPacked;
constexpr exr_result_t kDone = EXR_ERR_SUCCESS;

}  // namespace

struct ExrFile::Context {
    std::string_view bytes;
    std::string reason = {};  ///< OpenEXR's first message
    exr_context_t exr = nullptr;
};

namespace {

void* zeroed(size_t size) { return std::calloc(1, size); }

template <class Context>
void onError(exr_const_context_t exr, exr_result_t, const char* message) {
    void* user = nullptr;
    if (exr == nullptr || exr_get_user_data(exr, &user) != kDone || user == nullptr) { return; }
    auto* context = static_cast<Context*>(user);
    if (context->reason.empty()) { context->reason = message; }
}

template <class Context>
int64_t readBytes(exr_const_context_t, void* user, void* out, uint64_t size, uint64_t offset,
                  exr_stream_error_func_ptr_t) {
    const std::string_view bytes = static_cast<Context*>(user)->bytes;
    if (offset > bytes.size()) { return 0; }
    const uint64_t read = std::min(size, bytes.size() - offset);
    std::memcpy(out, bytes.data() + offset, read);
    return static_cast<int64_t>(read);
}

template <class Context>
int64_t sizeOf(exr_const_context_t, void* user) {
    return static_cast<int64_t>(static_cast<Context*>(user)->bytes.size());
}

ExrPixelType typeOf(exr_pixel_type_t type) {
    return type == EXR_PIXEL_UINT ? ExrPixelType::Uint
                                  : (type == EXR_PIXEL_HALF ? ExrPixelType::Half : ExrPixelType::Float);
}

ExrWindow windowOf(const exr_attr_box2i_t& box) { return {box.min.x, box.min.y, box.max.x, box.max.y}; }

std::map<std::string, std::string> textAttributes(exr_const_context_t exr, int part) {
    std::map<std::string, std::string> texts;
    int32_t count = 0;
    exr_get_attribute_count(exr, part, &count);
    for (int32_t i = 0; i < count; ++i) {
        const exr_attribute_t* attribute = nullptr;
        exr_get_attribute_by_index(exr, part, EXR_ATTR_LIST_FILE_ORDER, i, &attribute);
        if (attribute != nullptr && attribute->type == EXR_ATTR_STRING) {
            texts[attribute->name] =
                std::string(attribute->string->str, static_cast<size_t>(attribute->string->length));
        }
    }
    return texts;
}

/// Frees a pipeline, whatever became of it.
struct Pipeline {
    explicit Pipeline(exr_const_context_t context) : exr(context) {}
    ~Pipeline() { exr_decoding_destroy(exr, &decode); }
    Pipeline(const Pipeline&) = delete;
    Pipeline& operator=(const Pipeline&) = delete;

    exr_const_context_t exr;
    exr_decode_pipeline_t decode = EXR_DECODE_PIPELINE_INITIALIZER;
};

/// Where the channels of a chunk go, whose first pixel is so far from the data window's.
struct Aim {
    const ExrPart& part;
    std::vector<ExrTarget> targets;  ///< of each channel of the part; without values where it is not wanted
    int64_t left = 0, top = 0;
};

/// Copies a row of a channel to its target.
void unpackRow(const Aim& aim, size_t channel, int64_t row, const uint8_t* stored, size_t count) {
    const ExrTarget& target = aim.targets[channel];
    const ExrPartChannel& info = aim.part.channels[channel];
    const int64_t rowLength = (aim.part.data.width() + info.xSampling - 1) / info.xSampling;
    const int64_t first = row / info.ySampling * rowLength + aim.left / info.xSampling;
    auto* out = static_cast<uint8_t*>(target.values) + static_cast<size_t>(first) * target.stride;
    const bool isHalf = info.type == ExrPixelType::Half;
    for (size_t i = 0; i < count; ++i, stored += isHalf ? 2 : 4, out += target.stride) {
        if (info.type == ExrPixelType::Uint) {
            std::memcpy(out, stored, sizeof(uint32_t));
        } else {
            const float value = storedFloat(stored, isHalf ? 2 : 4);
            std::memcpy(out, &value, sizeof value);
        }
    }
}

/// OpenEXR's own routine writes through null pointers where channels at half resolution are not wanted.
exr_result_t unpack(exr_decode_pipeline_t* decode) {
    const Aim& aim = *static_cast<const Aim*>(decode->decoding_user_data);
    const auto* stored = static_cast<const uint8_t*>(decode->unpacked_buffer);
    uint64_t left = stored != nullptr ? decode->chunk.unpacked_size : 0;
    for (int64_t row = aim.top; row < aim.top + decode->chunk.height; ++row) {
        for (size_t c = 0; c < aim.targets.size(); ++c) {
            const exr_coding_channel_info_t& channel = decode->channels[c];
            if ((aim.part.data.minY + row) % channel.y_samples != 0) { continue; }
            const auto count = static_cast<size_t>(channel.width);
            const uint64_t bytes = count * static_cast<size_t>(channel.bytes_per_element);
            if (bytes > left) { return EXR_ERR_CORRUPT_CHUNK; }
            if (aim.targets[c].values != nullptr) { unpackRow(aim, c, row, stored, count); }
            stored += bytes;
            left -= bytes;
        }
    }
    return kDone;
}

/// Calls decode(chunk, left, top) for each tile of the largest picture in the part, until it fails.
template <class Decode>
bool forEachTile(exr_const_context_t exr, const ExrPart& part, Decode decode) {
    uint32_t width = 0, height = 0;
    exr_tile_level_mode_t levels{};
    exr_tile_round_mode_t rounding{};
    if (exr_get_tile_descriptor(exr, part.index, &width, &height, &levels, &rounding) != kDone ||
        width == 0 || height == 0) {
        return false;
    }
    exr_chunk_info_t chunk{};
    for (int64_t top = 0; top < part.data.height(); top += height) {
        for (int64_t left = 0; left < part.data.width(); left += width) {
            const int column = static_cast<int>(left / width);
            const int row = static_cast<int>(top / height);
            if (exr_read_tile_chunk_info(exr, part.index, column, row, 0, 0, &chunk) != kDone ||
                !decode(chunk, left, top)) {
                return false;
            }
        }
    }
    return true;
}

/// The same for each block of scan lines.
template <class Decode>
bool forEachScanLineBlock(exr_const_context_t exr, const ExrPart& part, Decode decode) {
    int32_t rows = 0;
    if (exr_get_scanlines_per_chunk(exr, part.index, &rows) != kDone || rows <= 0) { return false; }
    exr_chunk_info_t chunk{};
    for (int64_t top = 0; top < part.data.height(); top += rows) {
        const int y = static_cast<int>(part.data.minY + top);
        if (exr_read_scanline_chunk_info(exr, part.index, y, &chunk) != kDone ||
            !decode(chunk, int64_t{0}, top)) {
            return false;
        }
    }
    return true;
}

}  // namespace

void ExrFile::CloseContext::operator()(Context* context) const {
    if (context->exr != nullptr) { exr_finish(&context->exr); }
    delete context;
}

Error ExrFile::broken() const {
    return imageError(path_, fmt::format("is a broken or unsupported OpenEXR file: {}", context_->reason));
}

Result<ExrFile> ExrFile::open(std::string_view bytes, const std::string& path) {
    if (!looksLikeExr(bytes)) {
        return imageError(path, "is not an OpenEXR file (its first four bytes are wrong)");
    }
    ExrFile file;
    file.path_ = path;
    file.context_.reset(new Context{bytes});
    exr_context_initializer_t setup = EXR_DEFAULT_CONTEXT_INITIALIZER;
    setup.user_data = file.context_.get();
    setup.error_handler_fn = onError<Context>;
    setup.read_fn = readBytes<Context>;
    setup.size_fn = sizeOf<Context>;
    setup.alloc_fn = zeroed;
    setup.free_fn = std::free;
    setup.max_image_width = setup.max_image_height = kMaxSide;
    int count = 0;
    if (exr_start_read(&file.context_->exr, "picture", &setup) != kDone ||
        exr_get_count(file.context_->exr, &count) != kDone) {
        return file.broken();
    }
    for (int part = 0; part < count; ++part) {
        if (const Status added = file.addPart(part, bytes.size()); !added) { return added.error(); }
    }
    if (file.parts_.empty()) { return imageError(path, "holds deep pixels only; expected flat ones"); }
    return file;
}

Status ExrFile::addPart(int index, uint64_t fileSize) {
    exr_const_context_t exr = context_->exr;
    exr_storage_t storage{};
    exr_attr_box2i_t data{}, display{};
    const exr_attr_chlist_t* channels = nullptr;
    exr_compression_t compression{};
    int32_t chunks = 0;
    if (exr_get_storage(exr, index, &storage) != kDone) { return broken(); }
    if (storage != EXR_STORAGE_SCANLINE && storage != EXR_STORAGE_TILED) { return {}; }
    if (exr_get_data_window(exr, index, &data) != kDone ||
        exr_get_display_window(exr, index, &display) != kDone ||
        exr_get_channels(exr, index, &channels) != kDone ||
        exr_get_compression(exr, index, &compression) != kDone ||
        exr_get_chunk_count(exr, index, &chunks) != kDone) {
        return broken();
    }
    ExrPart part{.index = index,
                 .isTiled = storage == EXR_STORAGE_TILED,
                 .data = windowOf(data),
                 .display = windowOf(display),
                 .channels = {},
                 .chromaticities = {},
                 .attributes = textAttributes(exr, index)};
    double pixelBytes = 0.0;
    for (int i = 0; i < channels->num_channels; ++i) {
        const exr_attr_chlist_entry_t& entry = channels->entries[i];
        part.channels.push_back(
            {entry.name.str, typeOf(entry.pixel_type), entry.x_sampling, entry.y_sampling});
        pixelBytes += (entry.pixel_type == EXR_PIXEL_HALF ? 2.0 : 4.0) /
                      (static_cast<double>(entry.x_sampling) * static_cast<double>(entry.y_sampling));
    }
    const bool dwa = compression == EXR_COMPRESSION_DWAA || compression == EXR_COMPRESSION_DWAB;
    const bool b44 = compression == EXR_COMPRESSION_B44 || compression == EXR_COMPRESSION_B44A;
    const auto isHalf = [](const ExrPartChannel& channel) { return channel.type == ExrPixelType::Half; };
    part.needsClassicLibrary = dwa || (b44 && !std::ranges::all_of(part.channels, isHalf));
    const double mostPixels = (dwa ? kMostPackedByDwa : kMostPacked) / pixelBytes;
    const uint64_t width = static_cast<uint64_t>(std::max(part.data.width(), int64_t{0}));
    const uint64_t height = static_cast<uint64_t>(std::max(part.data.height(), int64_t{0}));
    if (Status size = checkStatedSize(path_, width, height, fileSize, mostPixels); !size) { return size; }
    if (chunks < 0 || static_cast<uint64_t>(chunks) > fileSize / sizeof(uint64_t)) {
        return brokenImage(path_,
                           fmt::format("a table of {} chunks cannot be in {} bytes", chunks, fileSize));
    }
    exr_attr_chromaticities_t chroma{};
    if (exr_attr_get_chromaticities(exr, index, "chromaticities", &chroma) == kDone) {
        part.chromaticities = {Vec2(chroma.red_x, chroma.red_y), Vec2(chroma.green_x, chroma.green_y),
                               Vec2(chroma.blue_x, chroma.blue_y), Vec2(chroma.white_x, chroma.white_y)};
    }
    parts_.push_back(std::move(part));
    return {};
}

Status ExrFile::read(const ExrPart& part, std::span<const ExrTarget> targets) {
    if (part.needsClassicLibrary) { return readByClassicLibrary(context_->bytes, path_, part, targets); }
    exr_const_context_t exr = context_->exr;
    Pipeline pipeline(exr);
    exr_decode_pipeline_t* decode = &pipeline.decode;
    Aim aim{part, std::vector<ExrTarget>(part.channels.size())};
    for (const ExrTarget& target : targets) {
        aim.targets[target.channel] = target;
    }
    context_->reason.clear();
    bool first = true;
    const auto decodeChunk = [&](const exr_chunk_info_t& chunk, int64_t left, int64_t top) {
        const exr_result_t ready = first ? exr_decoding_initialize(exr, part.index, &chunk, decode)
                                         : exr_decoding_update(exr, part.index, &chunk, decode);
        if (ready != kDone) { return false; }
        if (first && exr_decoding_choose_default_routines(exr, part.index, decode) != kDone) { return false; }
        first = false;
        aim.left = left;
        aim.top = top;
        decode->decoding_user_data = &aim;
        decode->unpack_and_convert_fn = unpack;
        return exr_decoding_run(exr, part.index, decode) == kDone;
    };
    const bool whole =
        part.isTiled ? forEachTile(exr, part, decodeChunk) : forEachScanLineBlock(exr, part, decodeChunk);
    return whole ? Status() : broken();
}

}  // namespace glint
