#include "engine/builders/mip_levels.h"

#include <algorithm>

#include "engine/kernels/texture.h"

namespace glint {
namespace {

/// Up to three neighbours of a row or column, and what they count for in one of half as many.
struct Cover {
    int first;
    int count;
    float weights[3];
};

Cover coverOf(int index, int size) {
    const int smaller = nextMipSize(size);
    // In parts of a smaller texel, so that all is whole numbers: texel i reaches from i * smaller on.
    const int begin = index * size, end = begin + size;
    Cover cover{begin / smaller, 0, {}};
    for (int i = cover.first; i * smaller < end; ++i) {
        const int overlap = std::min(end, (i + 1) * smaller) - std::max(begin, i * smaller);
        cover.weights[cover.count++] = static_cast<float>(overlap) / static_cast<float>(size);
    }
    return cover;
}

struct Level {
    int width, height;
    std::vector<Vec3> texels;
};

Level halved(const Level& from) {
    Level to{nextMipSize(from.width), nextMipSize(from.height), {}};
    to.texels.reserve(static_cast<size_t>(to.width) * static_cast<size_t>(to.height));
    for (int y = 0; y < to.height; ++y) {
        const Cover rows = coverOf(y, from.height);
        for (int x = 0; x < to.width; ++x) {
            const Cover columns = coverOf(x, from.width);
            Vec3 sum(0.0f);
            for (int j = 0; j < rows.count; ++j) {
                const Vec3* row =
                    &from.texels[static_cast<size_t>(rows.first + j) * static_cast<size_t>(from.width)];
                for (int i = 0; i < columns.count; ++i) {
                    sum += rows.weights[j] * columns.weights[i] * row[columns.first + i];
                }
            }
            to.texels.push_back(sum);
        }
    }
    return to;
}

}  // namespace

std::vector<float> mipLevels(const TextureView& texture) {
    Level level{texture.width, texture.height, {}};
    level.texels.reserve(static_cast<size_t>(level.width) * static_cast<size_t>(level.height));
    for (int y = 0; y < level.height; ++y) {
        for (int x = 0; x < level.width; ++x) {
            level.texels.push_back(detail::texel(texture, x, y));
        }
    }
    std::vector<float> values;
    values.reserve(mipValues(texture.width, texture.height));
    while (level.width > 1 || level.height > 1) {
        level = halved(level);
        for (const Vec3& texel : level.texels) {
            values.insert(values.end(), {texel.x, texel.y, texel.z});
        }
    }
    return values;
}

}  // namespace glint
