// Texts of scenes with characters changed, added and taken away at random (fixed seeds).
#pragma once

#include <functional>
#include <random>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "engine/builders/scene_validation.h"
#include "engine/io/scene_loader.h"
#include "tests/support/temp_folder.h"

namespace glint::test {

/// `often`: characters that mean something in the format, and are put in more than others.
inline std::string damagedText(const std::string& good, std::string_view often, std::mt19937& random) {
    std::string text = good;
    for (size_t changes = 1 + random() % 4; changes > 0 && !text.empty(); --changes) {
        const size_t at = random() % text.size();
        switch (random() % 4) {
            case 0:
                text.erase(at, random() % 30);
                break;
            case 1:
                text.insert(at, good.substr(random() % good.size(), random() % 60));
                break;
            default:
                text[at] = random() % 4 == 0 ? static_cast<char>(random()) : often[random() % often.size()];
        }
    }
    return text;
}

/// Damaged scenes open as sound ones or give an error with its file. Returns how many opened.
inline int openDamagedScenes(const TempFolder& folder, const std::string& name, const std::string& good,
                             std::string_view often) {
    constexpr int kRounds = 1500;
    std::mt19937 random(5);
    int opened = 0;
    for (int round = 0; round < kRounds; ++round) {
        const std::string text = damagedText(good, often, random);
        const auto scene = loadScene(folder.write(name, text), {.allowMissing = round % 2 == 0});
        if (scene) {
            ++opened;
            const Status valid = validateScene(*scene, EditKind::Everything);
            EXPECT_TRUE(valid) << valid.error().format() << text;
        } else {
            EXPECT_FALSE(scene.error().message.empty());
            EXPECT_FALSE(scene.error().place.file.empty());
        }
    }
    return opened;
}

}  // namespace glint::test
