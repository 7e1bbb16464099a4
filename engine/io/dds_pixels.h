// The pixels of DDS files. Internal to their reader (image_dds.cpp).
#pragma once

#include <cstdint>

#include "engine/base/result.h"
#include "engine/io/byte_stream.h"
#include "engine/scene/image.h"

namespace glint {

struct DdsHeader {
    uint32_t height = 0, width = 0;
    uint32_t mipLevels = 1;  ///< of each face, the largest first
    uint32_t fourCc = 0;     ///< of blocks and floats; 0: plain pixels
    uint32_t bits = 0;       ///< of a plain pixel
    uint32_t masks[4] = {};
    bool isCubeMap = false, hasAllFaces = false;
    uint32_t dxgiFormat = 0;  ///< where the fields above cannot say it
};

/// Whether the pixels are of a kind that is read.
bool isReadable(const DdsHeader& header);
/// The picture that comes next, of the header's size. Where the bytes end too early, the reader has failed.
SceneImage readDdsFace(const DdsHeader& header, ByteReader* bytes);
/// Passes over its smaller copies, which follow it.
void skipDdsCopies(const DdsHeader& header, ByteReader* bytes);

}  // namespace glint
