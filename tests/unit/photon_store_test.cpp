// Photon look-ups against brute force, over radii that differ by a million, and their independence
// of threads.
#include "engine/render/photon_store.h"

#include <algorithm>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "engine/base/parallel.h"
#include "engine/math/octahedral.h"

namespace glint {
namespace {

/// Photons on a floor, a wall and in one tight cluster; packed[0] carries the photon's number.
std::vector<Photon> makePhotons(uint32_t count) {
    std::mt19937 rng(7);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    std::vector<Photon> photons(count);
    for (uint32_t i = 0; i < count; ++i) {
        Vec3 p(uniform(rng), uniform(rng), 0.0f);
        if (i % 3 == 1) {
            p = Vec3(0.0f, p.x, p.y);
        } else if (i % 3 == 2) {
            p = Vec3(0.5f) + 1e-4f * Vec3(p.x, p.y, uniform(rng));
        }
        photons[i] = {p, Vec3(1.0f + static_cast<float>(i)), {i, 0}};
    }
    return photons;
}

GridSpace unitSpace() { return {Vec3(-0.01f), 1.02f / static_cast<float>(1 << kGridBitsPerAxis)}; }

constexpr uint32_t kAllLevels = (1u << kGridLevels) - 1;

void fill(PhotonStore* store, const std::vector<Photon>& photons, size_t perChunk, int threads) {
    const size_t chunks = (photons.size() + perChunk - 1) / perChunk;
    store->reset(photons.size(), chunks);
    parallelChunks(static_cast<int64_t>(chunks), 1, threads, [&](int64_t chunk, int64_t) {
        const size_t begin = static_cast<size_t>(chunk) * perChunk;
        for (size_t i = begin; i < std::min(begin + perChunk, photons.size()); ++i) {
            store->writer(static_cast<size_t>(chunk)).add(photons[i]);
        }
    });
    ASSERT_FALSE(store->overflowed());
}

template <class PhotonMap>
std::vector<uint32_t> photonsWithin(const PhotonMap& map, const Vec3& center, float radius) {
    std::vector<uint32_t> found;
    map.visitNear(center, radius, [&](const Photon& photon) {
        if (lengthSquared(photon.p - center) < radius * radius) { found.push_back(photon.packed[0]); }
    });
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<uint32_t> bruteForce(const std::vector<Photon>& photons, const Vec3& center, float radius) {
    std::vector<uint32_t> found;
    for (const Photon& photon : photons) {
        if (lengthSquared(photon.p - center) < radius * radius) { found.push_back(photon.packed[0]); }
    }
    return found;
}

TEST(PhotonStore, GridAndTreeFindWhatBruteForceFinds) {
    const std::vector<Photon> photons = makePhotons(5000);
    PhotonStore grid;
    fill(&grid, photons, 333, 2);
    grid.buildGrid(unitSpace(), kAllLevels, 2);
    PhotonStore tree;
    fill(&tree, photons, 333, 2);
    tree.buildTree(2);
    ASSERT_EQ(grid.photonCount(), photons.size());
    std::mt19937 rng(11);
    std::uniform_real_distribution<float> exponent(-6.0f, 0.5f);
    size_t found = 0;
    for (int query = 0; query < 3000; ++query) {
        const Vec3 center = photons[rng() % photons.size()].p + Vec3(1e-3f);
        const float radius = std::pow(10.0f, exponent(rng));
        const std::vector<uint32_t> expected = bruteForce(photons, center, radius);
        found += expected.size();
        ASSERT_EQ(photonsWithin(grid.grid(), center, radius), expected) << "radius " << radius;
        ASSERT_EQ(photonsWithin(tree.tree(), center, radius), expected) << "radius " << radius;
    }
    EXPECT_GT(found, 100000u) << "the queries must find something";
}

TEST(PhotonStore, OrderDoesNotDependOnThreads) {
    const std::vector<Photon> photons = makePhotons(20000);
    const auto orderWith = [&](int threads, bool asTree) {
        PhotonStore store;
        fill(&store, photons, 1000, threads);
        if (asTree) {
            store.buildTree(threads);
        } else {
            store.buildGrid(unitSpace(), kAllLevels, threads);
        }
        const View<Photon> ordered = asTree ? store.tree().photons : store.grid().photons;
        std::vector<uint32_t> order;
        for (uint32_t i = 0; i < ordered.count; ++i) {
            order.push_back(ordered[i].packed[0]);
        }
        return order;
    };
    for (const bool asTree : {false, true}) {
        const std::vector<uint32_t> reference = orderWith(1, asTree);
        EXPECT_EQ(std::set<uint32_t>(reference.begin(), reference.end()).size(), photons.size());
        EXPECT_EQ(orderWith(2, asTree), reference);
        EXPECT_EQ(orderWith(3, asTree), reference);
    }
}

TEST(PhotonStore, CountsWhatDoesNotFitInsteadOfWritingIt) {
    const std::vector<Photon> photons = makePhotons(1000);
    PhotonStore store;
    store.reset(0, 1);
    for (const Photon& photon : photons) {
        store.writer(0).add(photon);
    }
    EXPECT_TRUE(store.overflowed());
    EXPECT_GE(store.wanted(), photons.size());
    store.reset(store.wanted(), 1);
    for (const Photon& photon : photons) {
        store.writer(0).add(photon);
    }
    EXPECT_FALSE(store.overflowed());
    store.buildTree(1);
    EXPECT_EQ(store.photonCount(), photons.size());
}

TEST(PhotonStore, NoPhotonsAreFine) {
    PhotonStore store;
    store.reset(100, 4);
    store.buildGrid(unitSpace(), kAllLevels, 2);
    EXPECT_TRUE(photonsWithin(store.grid(), Vec3(0.5f), 0.5f).empty());
    store.reset(100, 4);
    store.buildTree(2);
    EXPECT_TRUE(photonsWithin(store.tree(), Vec3(0.5f), 0.5f).empty());
}

TEST(PhotonStore, PhotonBytesStayWithinTheirBudget) {
    const std::vector<Photon> photons = makePhotons(100000);
    PhotonStore store;
    fill(&store, photons, 1000, 2);
    store.buildGrid(unitSpace(), 1u << 5, 2);
    EXPECT_LE(PhotonStore::kBytesPerPhoton, 48u);
    // Beyond the photons themselves: one partly filled block a chunk, and the tables, whose cells are fewer
    // than photons.
    const size_t blocks = 100 * PhotonStore::kBlockPhotons * sizeof(Photon);
    const size_t tables = 2 * 2 * photons.size() * sizeof(GridSlot);
    EXPECT_LE(store.bytes(), photons.size() * PhotonStore::kBytesPerPhoton + 2 * blocks + tables);
}

TEST(Octahedral, PackedDirectionsAreNear) {
    std::mt19937 rng(3);
    std::normal_distribution<float> normal;
    double worst16 = 0.0;
    double worst12 = 0.0;
    for (int i = 0; i < 100000; ++i) {
        const Vec3 w = glm::normalize(Vec3(normal(rng), normal(rng), normal(rng)));
        worst16 = std::max(worst16,
                           static_cast<double>(glm::length(unpackUnitVector<16>(packUnitVector<16>(w)) - w)));
        worst12 = std::max(worst12,
                           static_cast<double>(glm::length(unpackUnitVector<12>(packUnitVector<12>(w)) - w)));
    }
    EXPECT_LT(worst16, 7e-5);
    EXPECT_LT(worst12, 1.1e-3);
    for (const Vec3 axis : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, -1), Vec3(0, 0, 1)}) {
        EXPECT_EQ(unpackUnitVector<16>(packUnitVector<16>(axis)), axis);
    }
}

}  // namespace
}  // namespace glint
