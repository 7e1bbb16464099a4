// Films keep their bits from version to version: the program's own scenes, five text scenes and an OBJ
// file, under both integrators and with each kernel variant that the CPU back end may choose, against
// stored fingerprints.
//
// tests/README.md says how to store new ones where a picture is meant to change.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "engine/base/content_hash.h"
#include "engine/io/scene_loader.h"
#include "tests/support/session_render.h"

namespace glint {
namespace {

constexpr const char* kStored = GLINT_SOURCE_DIR "/tests/data/film_hashes.txt";
constexpr int kSize = 64;
constexpr uint32_t kPasses = 4;
constexpr uint32_t kPhotons = 20000;

std::vector<std::filesystem::path> sceneFiles() {
    std::vector<std::filesystem::path> files;
    for (const char* folder : {GLINT_SOURCE_DIR "/scenes", GLINT_SOURCE_DIR "/tests/data/film"}) {
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            const std::string name = entry.path().filename().string();
            const bool isScene = name.ends_with(".json") || name.ends_with(".txt") || name.ends_with(".obj");
            if (isScene && !name.ends_with(".schema.json")) { files.push_back(entry.path()); }
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// Of everything that a film and SPPM's statistics hold, field by field.
std::string fingerprint(const SessionCapture& capture) {
    ContentHash hash;
    for (const FilmPixel& pixel : capture.film.pixels()) {
        for (const double sum : pixel.mean) {
            hash.add(sum);
        }
        hash.add(pixel.luminanceM2);
        hash.add(pixel.count);
    }
    if (const SppmState* photons = asSppm(capture.statistics.get())) {
        for (const SppmPixel& pixel : photons->pixels) {
            hash.add(pixel.radiusSquared);
            hash.add(pixel.photonCount);
            for (const double flux : pixel.flux) {
                hash.add(flux);
            }
        }
    }
    return hash.finish().hex();
}

std::string fingerprintOf(SceneDescription scene, IntegratorKind integrator, KernelChoice choice) {
    scene.resolution = {kSize, kSize};
    scene.options.integrator = integrator;
    scene.sppm.photonsPerPass = kPhotons;
    return fingerprint(test::renderSession(makeCpuBackend(2, choice), scene, kPasses, 2));
}

using Fingerprints = std::map<std::string, std::string>;

Fingerprints storedFingerprints() {
    Fingerprints stored;
    std::ifstream file(kStored);
    for (std::string name, hash; file >> name >> hash;) {
        stored[name] = hash;
    }
    return stored;
}

void expectStored(const Fingerprints& rendered, const Fingerprints& stored) {
    EXPECT_EQ(rendered.size(), stored.size());
    for (const auto& [name, hash] : rendered) {
        const auto known = stored.find(name);
        ASSERT_NE(known, stored.end()) << name << " is not in " << kStored;
        EXPECT_EQ(hash, known->second) << name;
    }
}

TEST(FilmHash, EveryFilmHasTheStoredBits) {
    Fingerprints rendered;
    for (const std::filesystem::path& file : sceneFiles()) {
        const auto scene = loadScene(file.string(), {});
        ASSERT_TRUE(scene) << scene.error().format();
        for (const IntegratorKind integrator : {IntegratorKind::PathTracing, IntegratorKind::Sppm}) {
            const std::string name =
                file.filename().string() + (integrator == IntegratorKind::Sppm ? ":sppm" : ":pt");
            rendered[name] = fingerprintOf(*scene, integrator, KernelChoice::Specialised);
            EXPECT_EQ(fingerprintOf(*scene, integrator, KernelChoice::Full), rendered[name]) << name;
        }
    }
    if (const char* out = std::getenv("GLINT_STORE_FILM_HASHES")) {
        std::ofstream file(out);
        for (const auto& [name, hash] : rendered) {
            file << name << ' ' << hash << '\n';
        }
        return;
    }
    expectStored(rendered, storedFingerprints());
}

}  // namespace
}  // namespace glint
