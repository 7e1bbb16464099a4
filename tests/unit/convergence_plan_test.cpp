// What `glint converge` compares and when it measures: the variants' grammar, stops, seeds.
#include <cmath>

#include <gtest/gtest.h>

#include "engine/report/convergence_run.h"
#include "engine/report/convergence_schedule.h"
#include "engine/report/html_text.h"

namespace glint {
namespace {

TEST(ConvergenceVariant, SettingsReplaceTheScenesOwn) {
    const auto variants =
        parseVariants("pt,sppm:radius=auto:2:alpha=0.5:lookup=tree,pt:sampler=independent:threads=3");
    ASSERT_TRUE(variants) << variants.error().message;
    ASSERT_EQ(variants->size(), 3u);
    EXPECT_EQ((*variants)[0].name, "path") << "an integrator has one name, whichever was typed";
    EXPECT_EQ((*variants)[1].name, "sppm radius=auto:2 alpha=0.5 lookup=tree");
    EXPECT_EQ((*variants)[1].text, "sppm:radius=auto:2:alpha=0.5:lookup=tree");
    VariantSettings scene;
    scene.sppm.radiusWorld = 0.7f;
    scene.sppm.photonsPerPass = 123;
    const VariantSettings sppm = (*variants)[1].applyTo(scene);
    EXPECT_EQ(sppm.options.integrator, IntegratorKind::Sppm);
    EXPECT_EQ(sppm.sppm.radiusWorld, 0.0f);
    EXPECT_EQ(sppm.sppm.radiusFootprints, 2.0f);
    EXPECT_EQ(sppm.sppm.alpha, 0.5f);
    EXPECT_EQ(sppm.sppm.lookup, PhotonLookupKind::Tree);
    EXPECT_EQ(sppm.sppm.photonsPerPass, 123u) << "what a variant does not name stays";
    const VariantSettings paths = (*variants)[2].applyTo(scene);
    EXPECT_EQ(paths.options.sampler, SamplerKind::Independent);
    EXPECT_EQ(paths.threads, 3);
    EXPECT_EQ((*variants)[0].applyTo(scene).options.sampler, SamplerKind::Sobol);
}

TEST(ConvergenceVariant, EverySettingCanBeRead) {
    EXPECT_TRUE(parseVariants("path:roulette=2:clamp=10:backend=cuda:kernel=full"));
    EXPECT_TRUE(parseVariants("sppm:radius=0.05:photons=1000:direct=photons:kernel=specialised"));
    EXPECT_TRUE(parseVariants("sppm:radius=auto"));
    const auto trees = parseVariants("rc:accelerator=kdtree");
    ASSERT_TRUE(trees);
    const VariantSettings settings = (*trees)[0].applyTo({});
    EXPECT_EQ(settings.options.integrator, IntegratorKind::RayCast);
    EXPECT_EQ(settings.options.accelerator, AcceleratorKind::KdTree);
}

TEST(ConvergenceVariant, MistakesAreNamed) {
    const std::pair<const char*, const char*> mistakes[] = {
        {"", "expected names"},
        {"pt,", "expected names"},
        {"ptt", "did you mean 'pt'"},
        {"pt:smapler=sobol", "did you mean 'sampler'"},
        {"pt:sampler=halton", "sobol or independent"},
        {"pt:radius=3", "expected sppm:radius=3"},
        {"pt:", "expected key=value"},
        {"pt:threads", "expected key=value"},
        {"pt:=3", "expected key=value"},
        {"pt:threads=0", "from 1 to 1024"},
        {"pt:threads=2x", "from 1 to 1024"},
        {"pt:threads=2:threads=3", "stands twice"},
        {"pt,sppm,path", "there twice"},
        {"sppm:alpha=1", "between 0 and 1"},
        {"sppm:alpha=nan", "between 0 and 1"},
        {"sppm:radius=auto:", "auto:K"},
        {"sppm:radius=-1", "auto:K"},
        {"sppm:radius=inf", "auto:K"},
        {"sppm:photons=0", "photons in a pass"},
        {"pt:clamp=nan", "the most radiance"},
    };
    for (const auto& [text, expected] : mistakes) {
        const auto variants = parseVariants(text);
        ASSERT_FALSE(variants) << text;
        EXPECT_NE(variants.error().message.find(expected), std::string::npos)
            << text << ": " << variants.error().message;
    }
}

TEST(Schedule, SecondsAreSpacedEvenlyOnALogarithmicScale) {
    const SecondsSchedule schedule(10.0, 9);
    std::vector<double> stops{0.01};
    while (const auto next = schedule.next(0.01, stops.back())) {
        stops.push_back(*next);
    }
    ASSERT_EQ(stops.size(), 9u);
    EXPECT_EQ(stops.back(), 10.0);
    for (size_t i = 1; i < stops.size(); ++i) {
        EXPECT_NEAR(std::log10(stops[i] / stops[i - 1]), 3.0 / 8.0, 1e-9);
    }
}

TEST(Schedule, SlowPassesSkipStops) {
    const SecondsSchedule schedule(10.0, 30);
    double now = 0.0;
    int stops = 0;
    // Passes of 1.3 s: a stop is reached at the end of the pass that it lies in.
    while (const auto next = schedule.next(1.3, now)) {
        now = 1.3 * std::ceil(*next / 1.3 - 1e-9);
        ++stops;
        ASSERT_LT(stops, 100);
    }
    EXPECT_LE(stops, 8) << "no more stops than passes";
    EXPECT_GE(now, 10.0);
    EXPECT_FALSE(SecondsSchedule(1.0, 5).next(2.0, 2.0)) << "the first pass took longer than all of it";
}

TEST(Schedule, StopsAtChosenMomentsToo) {
    const SecondsSchedule schedule(10.0, 3, {0.5, 4.0});
    std::vector<double> stops{0.1};
    while (const auto next = schedule.next(0.1, stops.back())) {
        stops.push_back(*next);
    }
    EXPECT_EQ(stops, (std::vector<double>{0.1, 0.5, 1.0, 4.0, 10.0}));
    EXPECT_EQ(spacedPasses(16, 3, {5.0, 4.0}), (std::vector<uint32_t>{1, 4, 5, 16}));
    EXPECT_EQ(decadesOf(20.0, 3), (std::vector<double>{0.2, 2.0, 20.0}));
    EXPECT_TRUE(decadesOf(20.0, 0).empty());
}

TEST(Schedule, PassesAreSpacedAndEachOnce) {
    EXPECT_EQ(spacedPasses(1, 16), (std::vector<uint32_t>{1}));
    EXPECT_EQ(spacedPasses(16, 5), (std::vector<uint32_t>{1, 2, 4, 8, 16}));
    const std::vector<uint32_t> many = spacedPasses(1000, 16);
    EXPECT_EQ(many.front(), 1u);
    EXPECT_EQ(many.back(), 1000u);
    for (size_t i = 1; i < many.size(); ++i) {
        EXPECT_GT(many[i], many[i - 1]);
    }
    EXPECT_EQ(spacedPasses(4000000000u, 4).back(), 4000000000u);
}

TEST(Seeds, ThoseOfTheReferenceAreLeftOut) {
    EXPECT_EQ(seedsBeside({}, 5, 3), (std::vector<uint32_t>{5, 6, 7}));
    EXPECT_EQ(seedsBeside({5, 7, 9}, 5, 3), (std::vector<uint32_t>{6, 8, 10}));
    EXPECT_EQ(seedsBeside({0}, 0xffffffffu, 2), (std::vector<uint32_t>{0xffffffffu, 1}));
}

TEST(HtmlText, EscapesAndEncodes) {
    EXPECT_EQ(htmlText("<a href=\"x\">'&'"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;");
    // RFC 4648, section 10.
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

}  // namespace
}  // namespace glint
