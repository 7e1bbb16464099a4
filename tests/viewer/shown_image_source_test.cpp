// What the display gets of a snapshot: small maps at once, large ones from a job, while the picture before
// stays; nothing of a scene before an edit; one scale for both sides of a comparison.
#include "viewer/window/shown_image_source.h"

#include <chrono>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "viewer/window/surface.h"

namespace glint {
namespace {

using Snapshot = std::shared_ptr<const FilmSnapshot>;

constexpr int kSmall = 16;
constexpr int kLarge = 512;  // a square of it is not coloured at once

Snapshot snapshotOf(int size, float noise, uint64_t generation = 1) {
    auto snapshot = std::make_shared<FilmSnapshot>();
    snapshot->ticket = generation;
    snapshot->width = snapshot->height = size;
    const size_t pixels = static_cast<size_t>(size) * static_cast<size_t>(size);
    snapshot->radiance.assign(3 * pixels, 1.0f);
    for (size_t i = 0; i < pixels; ++i) {
        snapshot->standardError.push_back(noise * static_cast<float>(1 + i % 97));
    }
    return snapshot;
}

class ShownImageSources : public testing::Test {
  protected:
    void SetUp() override {
        auto surface = makeHeadlessSurface({.width = 64, .height = 64});
        ASSERT_TRUE(surface) << surface.error().format();
        surface_ = std::move(*surface);
        for (auto& display : displays_) {
            auto created = ImageDisplay::create(surface_->gl());
            ASSERT_TRUE(created) << created.error().format();
            display = std::move(*created);
        }
    }

    static ShownImageSource::Wanted noiseOf(const Snapshot& snapshot) {
        return {snapshot, ShownImage::StandardError, nullptr, {}};
    }
    void show(const ShownImageSource::Wanted& left, const ShownImageSource::Wanted& right = {}) {
        sources_[0].show(left, nullptr, displays_[0].get());
        sources_[1].show(right, &sources_[0], displays_[1].get());
    }
    void settle(const ShownImageSource::Wanted& left, const ShownImageSource::Wanted& right = {}) {
        show(left, right);
        for (int i = 0; i < 20000 && (sources_[0].isBehind() || sources_[1].isBehind()); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            show(left, right);
        }
    }
    /// Whether a display shows the snapshot's noise, on that scale.
    void expectNoise(size_t side, const Snapshot& snapshot, MapScale scale) {
        EXPECT_EQ(sources_[side].shownImage(), ShownImage::StandardError);
        const auto wanted = falseColors(*snapshot, ShownImage::StandardError, nullptr, &scale);
        const auto shown = displays_[side]->readBack();
        ASSERT_EQ(shown.size() * 4, wanted.size() * 3);
        int wrong = 0;
        for (size_t i = 0; i < wanted.size() / 4; ++i) {
            for (size_t c = 0; c < 3; ++c) {
                wrong += shown[3 * i + c] != wanted[4 * i + c];
            }
        }
        EXPECT_EQ(wrong, 0);
    }

    std::unique_ptr<Surface> surface_;
    std::array<std::unique_ptr<ImageDisplay>, 2> displays_;
    std::array<ShownImageSource, 2> sources_;
};

TEST_F(ShownImageSources, ASmallMapIsThereAtOnce) {
    const Snapshot snapshot = snapshotOf(kSmall, 0.01f);
    show(noiseOf(snapshot));
    EXPECT_FALSE(sources_[0].isBehind());
    expectNoise(0, snapshot, {});
}

TEST_F(ShownImageSources, ALargeMapComesFromAJob) {
    const Snapshot snapshot = snapshotOf(kLarge, 0.01f);
    show({snapshot, ShownImage::Radiance, nullptr, {}});
    EXPECT_FALSE(sources_[0].isBehind());
    show(noiseOf(snapshot));
    EXPECT_TRUE(sources_[0].isBehind());
    EXPECT_EQ(sources_[0].shownImage(), ShownImage::Radiance) << "until the colours are there";
    settle(noiseOf(snapshot));
    expectNoise(0, snapshot, {});
    const Snapshot next = snapshotOf(kLarge, 0.003f);
    settle(noiseOf(next));
    expectNoise(0, next, {});
}

TEST_F(ShownImageSources, ColorsOfTheSceneBeforeAnEditAreDropped) {
    const Snapshot before = snapshotOf(kLarge, 0.01f);
    const Snapshot after = snapshotOf(kSmall, 0.02f, 2);
    show(noiseOf(before));
    show(noiseOf(after));
    // On a busy machine they may have been ready, and dropped, before the edit was shown: then none come.
    for (int i = 0; i < 3000 && !sources_[0].isReady(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    show(noiseOf(after));
    EXPECT_FALSE(sources_[0].isBehind());
    expectNoise(0, after, {});
}

TEST_F(ShownImageSources, BothSidesHaveOneScale) {
    for (const int size : {kSmall, kLarge}) {
        const Snapshot left = snapshotOf(size, 0.01f);
        const Snapshot right = snapshotOf(size, 0.0007f);
        settle(noiseOf(left), noiseOf(right));
        expectNoise(0, left, {});
        expectNoise(1, right, sources_[0].scale());
        // The left one goes on, the right one stays: its colours follow the scale.
        const Snapshot later = snapshotOf(size, 0.004f);
        settle(noiseOf(later), noiseOf(right));
        expectNoise(1, right, sources_[0].scale());
    }
}

TEST_F(ShownImageSources, LargeRadianceIsToneMappedByAJobWhereOpenGlIsSoftware) {
    ASSERT_TRUE(displays_[0]->isSoftware());
    const Snapshot snapshot = snapshotOf(1100, 0.01f);
    ShownImageSource::Wanted wanted{snapshot, ShownImage::Radiance, nullptr, {-1.0f, ToneMap::Srgb}};
    settle(wanted);
    EXPECT_NEAR(displays_[0]->readBack()[0], 255.0f * toneMapped(Vec3(1.0f), -1.0f, ToneMap::Srgb).x, 1.0f);
    wanted.look.exposureStops = -2.0f;
    settle(wanted);
    EXPECT_NEAR(displays_[0]->readBack()[0], 255.0f * toneMapped(Vec3(1.0f), -2.0f, ToneMap::Srgb).x, 1.0f);
}

}  // namespace
}  // namespace glint
