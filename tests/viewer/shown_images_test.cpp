// The table of images that can be shown of a render.
#include <algorithm>

#include <gtest/gtest.h>

#include "engine/render/integrator.h"
#include "engine/render/sppm_state.h"
#include "viewer/model/shown_image.h"

namespace glint {
namespace {

TEST(ShownImages, TheTableIsComplete) {
    std::vector<std::string> names;
    for (const ShownImageInfo& info : shownImages()) {
        names.emplace_back(info.name);
        EXPECT_EQ(&infoOf(info.image), &info);
        const bool hasNumbers = info.values || info.hitNumber != nullptr || info.isAgainstReference;
        const int sources = info.isRadiance() + hasNumbers + (info.hitColor != nullptr);
        EXPECT_EQ(sources, 1) << info.name;
        EXPECT_EQ(info.ask != nullptr, bool(info.values) || info.isOfHit()) << info.name;
        EXPECT_EQ(bool(info.readout), hasNumbers) << info.name;
        EXPECT_EQ(bool(info.scaleText), hasNumbers && info.colors != MapColors::PresentOrNot) << info.name;
        EXPECT_EQ(info.hitText != nullptr, info.hitColor != nullptr) << info.name;
        EXPECT_EQ(bool(info.has), info.lacking != nullptr) << info.name;
    }
    std::ranges::sort(names);
    EXPECT_EQ(std::ranges::adjacent_find(names), names.end()) << "names are unique";
}

TEST(ShownImages, WhatAnIntegratorLacksIsItsRadianceAndSaysSo) {
    const ShownImage radius = imageNamed("SPPM radius").value();
    FilmSnapshot snapshot;
    snapshot.width = snapshot.height = 1;
    snapshot.passes = 2;
    snapshot.radiance = {1.0f, 2.0f, 3.0f};
    snapshot.integrator = IntegratorKind::PathTracing;
    EXPECT_EQ(availableImage(snapshot, radius, nullptr), ShownImage::Radiance);
    EXPECT_EQ(noteInstead(snapshot, radius, nullptr), "Path tracing has no photons: its radiance");
    EXPECT_TRUE(carries(snapshot, radius)) << "it never will have more";
    EXPECT_EQ(pixelReadout(snapshot, radius, nullptr, {0, 0}), "R 1  G 2  B 3");
    snapshot.integrator = IntegratorKind::Sppm;
    EXPECT_EQ(availableImage(snapshot, radius, nullptr), radius);
    EXPECT_EQ(noteInstead(snapshot, radius, nullptr), "");
    EXPECT_FALSE(carries(snapshot, radius)) << "not yet";
    snapshot.maps = {{kRadiusMap, {0.25f}}, {kPhotonCountMap, {0.0f}}};
    EXPECT_EQ(pixelReadout(snapshot, radius, nullptr, {0, 0}), "radius 250 mm");
    EXPECT_EQ(pixelReadout(snapshot, imageNamed("Photon count").value(), nullptr, {0, 0}), "0.0 photons");
    snapshot.maps[0].values = {0.0f};
    for (const char* name : {"SPPM radius", "Visible points"}) {
        EXPECT_EQ(pixelReadout(snapshot, imageNamed(name).value(), nullptr, {0, 0}), "no visible point");
    }
}

TEST(ShownImages, EveryMapOfAnIntegratorCanBeShown) {
    for (const IntegratorInfo& integrator : kIntegratorTable) {
        const auto statistics = makeStatistics(integrator.kind, 1, 1);
        for (const IntegratorMapInfo& map : integratorType(integrator.kind).maps()) {
            ASSERT_TRUE(imageNamed(map.label)) << map.label;
            const ShownImageInfo& info = infoOf(*imageNamed(map.label));
            FilmSnapshot snapshot;
            snapshot.maps = statistics->maps();
            EXPECT_EQ(info.values(snapshot).size(), 1u) << "one a pixel";
            for (const IntegratorInfo& other : kIntegratorTable) {
                EXPECT_EQ(info.isOf(other.kind), other.kind == integrator.kind);
            }
        }
    }
}

}  // namespace
}  // namespace glint
