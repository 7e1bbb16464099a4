// Two lanes of multiply and rotate over 64-bit words, each lane fed by the other, with murmur-like
// final mixing.
#include "engine/base/content_hash.h"

#include <bit>
#include <cstring>

#include <fmt/format.h>

namespace glint {
namespace {

constexpr uint64_t kFactorLow = 0x9e3779b97f4a7c15u;   // 2^64 / golden ratio, odd
constexpr uint64_t kFactorHigh = 0xc2b2ae3d27d4eb4fu;  // an odd number with as many ones as zeros

/// Every input bit reaches every output bit.
uint64_t mixed(uint64_t x) {
    x = (x ^ (x >> 32)) * kFactorLow;
    x = (x ^ (x >> 29)) * kFactorHigh;
    return x ^ (x >> 32);
}

}  // namespace

void ContentHash::addWord(uint64_t word) {
    low_ = std::rotl((low_ ^ word) * kFactorLow, 29) + high_;
    high_ = std::rotl((high_ + word) * kFactorHigh, 31) ^ low_;
}

void ContentHash::addBytes(const void* data, size_t size) {
    beginBytes(size);
    addPiece(data, size);
}

void ContentHash::addPiece(const void* data, size_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (; size >= sizeof(uint64_t); size -= sizeof(uint64_t), bytes += sizeof(uint64_t)) {
        uint64_t word;
        std::memcpy(&word, bytes, sizeof word);
        addWord(word);
    }
    if (size > 0) {
        uint64_t word = 0;
        std::memcpy(&word, bytes, size);
        addWord(word);
    }
}

Hash128 ContentHash::finish() const {
    const uint64_t low = mixed(low_ + mixed(high_));
    return {low, mixed(high_ ^ low)};
}

std::string Hash128::hex() const { return fmt::format("{:016x}{:016x}", high, low); }

}  // namespace glint
