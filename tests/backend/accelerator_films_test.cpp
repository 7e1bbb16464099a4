// The choice of an acceleration structure changes no picture: films of every integrator, by kd-trees, by one
// box for each and by testing everything, have the bits of those by hierarchies of boxes. No two surfaces of
// these scenes are met at the same distance.
#include <gtest/gtest.h>

#include "engine/render/checkpoint.h"
#include "tests/support/film_bits.h"
#include "tests/support/session_render.h"
#include "tests/support/temp_folder.h"
#include "tests/support/test_scenes.h"

namespace glint::test {
namespace {

SessionCapture renderWith(AcceleratorKind accelerator, SceneDescription scene, IntegratorKind integrator) {
    scene.resolution = {32, 24};
    scene.sppm.photonsPerPass = 2000;
    scene.options.integrator = integrator;
    scene.options.accelerator = accelerator;
    return renderSession(makeCpuBackend(2), scene, 2, 2);
}

TEST(AcceleratorFilms, EveryKindGivesTheBitsOfTheDefault) {
    for (const SceneDescription& scene : {allMaterials(), turnedProfiles(), meshInstances()}) {
        for (const IntegratorInfo& integrator : kIntegratorTable) {
            SCOPED_TRACE(scene.title + ", " + integrator.key);
            const SessionCapture expected = renderWith(AcceleratorKind::Bvh, scene, integrator.kind);
            for (const AcceleratorKind kind :
                 {AcceleratorKind::KdTree, AcceleratorKind::Aabb, AcceleratorKind::None}) {
                const SessionCapture capture = renderWith(kind, scene, integrator.kind);
                expectSameBits(capture.film, expected.film);
                EXPECT_EQ(capture.film.rays(), expected.film.rays());
                if (integrator.kind != IntegratorKind::Sppm) { continue; }
                EXPECT_EQ(photonsOf(capture).emittedPhotons, photonsOf(expected).emittedPhotons);
                for (size_t i = 0; i < photonsOf(expected).pixels.size(); ++i) {
                    ASSERT_EQ(photonsOf(capture).radianceOf(i), photonsOf(expected).radianceOf(i));
                }
            }
        }
    }
}

TEST(AcceleratorFilms, ACheckpointGoesOnWithAnotherKind) {
    SceneDescription scene = meshInstances();
    scene.resolution = {32, 24};
    const TempFolder folder;
    const std::string path = folder.path("half.checkpoint");
    ASSERT_TRUE(saveCheckpoint(path, renderSession(makeCpuBackend(2), scene, 2, 2)));
    const SessionCapture expected = renderSession(makeCpuBackend(2), scene, 4, 2);
    scene.options.accelerator = AcceleratorKind::KdTree;
    Result<ResumePoint> half = loadCheckpoint(path, scene);
    ASSERT_TRUE(half) << half.error().format();
    expectSameBits(renderSession(makeCpuBackend(2), scene, 4, 2, std::move(*half)).film, expected.film);
}

}  // namespace
}  // namespace glint::test
