// Random numbers for paths, keyed by (seed, pixel, pass, dimension): no state to carry or to save, and no
// result that depends on the order of work. Host and device.
//
// Sobol (default): for every dimension, a 2-D (0,2)-sequence of its own: the first two Sobol dimensions with
// a shuffled index, Owen-scrambled by hashing; the pass is the index. Burley 2020, "Practical Hash-based Owen
// Scrambling". Independent: a hash of the key. Left out: correlation between pixels (blue noise), and joint
// stratification over more than one dimension pair.
#pragma once

#include "engine/kernels/dimensions.h"
#include "engine/kernels/features.h"
#include "engine/kernels/pass.h"
#include "engine/math/rng.h"
#include "engine/math/vec.h"

namespace glint {

/// The numbers of one path. Plain data.
struct Sampler {
    uint64_t pixelKey = 0;
    uint32_t pass = 0;
    uint32_t reversedPass = 0;
    SamplerKind tag = SamplerKind::Sobol;
};

/// The sampler of the path through pixel (x, y) in params.pass. The picture's size is no part of the key.
GLINT_HD inline Sampler makeSampler(const PassParams& params, int x, int y) {
    const uint64_t pixel = static_cast<uint64_t>(static_cast<uint32_t>(y)) << 32 | static_cast<uint32_t>(x);
    Sampler sampler;
    sampler.pixelKey = hashCounter(mixBits(pixel + 1), params.seed);
    sampler.pass = params.pass;
    sampler.reversedPass = reverseBits32(params.pass);
    sampler.tag = params.sampler;
    return sampler;
}

namespace detail {

/// Flips each bit depending on all lower bits and the seed (Laine and Karras 2011, with the constants of
/// Vegdahl 2021). Between two bit reversals this is an Owen scramble.
GLINT_HD inline uint32_t laineKarras(uint32_t v, uint32_t seed) {
    v ^= v * 0x3d20adeau;
    v += seed;
    v *= (seed >> 16) | 1u;
    v ^= v * 0x05526c56u;
    v ^= v * 0x53a22864u;
    return v;
}

/// The second Sobol dimension with its digits reversed (the first digit is bit 0). Its matrix is Pascal's
/// triangle modulo 2; binomial(j, i) is odd exactly where i's bits are a subset of j's (Lucas), so it is a
/// sum over supersets.
GLINT_HD inline uint32_t reversedSecondSobol(uint32_t index) {
    index ^= (index >> 1) & 0x55555555u;
    index ^= (index >> 2) & 0x33333333u;
    index ^= (index >> 4) & 0x0f0f0f0fu;
    index ^= (index >> 8) & 0x00ff00ffu;
    return index ^ (index >> 16);
}

GLINT_HD inline uint64_t independentBits(const Sampler& sampler, Dimension dimension) {
    const uint64_t counter = static_cast<uint64_t>(sampler.pass) << 32 | dimension.index;
    return hashCounter(sampler.pixelKey, counter);
}

/// Within every aligned block of 2^k passes the shuffled indices are an aligned block of 2^k, too.
GLINT_HD inline uint32_t shuffledIndex(const Sampler& sampler, uint64_t key) {
    return reverseBits32(laineKarras(sampler.reversedPass, static_cast<uint32_t>(key >> 32)));
}

template <FeatureMask kMask>
GLINT_HD bool isIndependent(const Sampler& sampler) {
    return hasFeature<kMask>(kFeatureIndependentSampler) && sampler.tag == SamplerKind::Independent;
}

}  // namespace detail

/// A number in [0, 1).
template <FeatureMask kMask>
GLINT_HD float get1D(const Sampler& sampler, Dimension dimension) {
    if (detail::isIndependent<kMask>(sampler)) {
        return uniformFloat(static_cast<uint32_t>(detail::independentBits(sampler, dimension) >> 32));
    }
    const uint64_t key = hashCounter(sampler.pixelKey, dimension.index);
    const uint32_t index = detail::shuffledIndex(sampler, key);
    return uniformFloat(reverseBits32(detail::laineKarras(index, static_cast<uint32_t>(key))));
}

/// Two numbers in [0, 1).
template <FeatureMask kMask>
GLINT_HD Vec2 get2D(const Sampler& sampler, Dimension dimension) {
    if (detail::isIndependent<kMask>(sampler)) {
        const uint64_t bits = detail::independentBits(sampler, dimension);
        return {uniformFloat(static_cast<uint32_t>(bits >> 32)), uniformFloat(static_cast<uint32_t>(bits))};
    }
    const uint64_t key = hashCounter(sampler.pixelKey, dimension.index);
    const auto secondSeed = static_cast<uint32_t>((key * 0xd1342543de82ef95ull) >> 32);
    const uint32_t index = detail::shuffledIndex(sampler, key);
    const uint32_t x = detail::laineKarras(index, static_cast<uint32_t>(key));
    const uint32_t y = detail::laineKarras(detail::reversedSecondSobol(index), secondSeed);
    const uint64_t both = reverseBits64(static_cast<uint64_t>(y) << 32 | x);
    return {uniformFloat(static_cast<uint32_t>(both >> 32)), uniformFloat(static_cast<uint32_t>(both))};
}

}  // namespace glint
