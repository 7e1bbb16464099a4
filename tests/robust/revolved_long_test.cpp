// Ten million random rays against surfaces of revolution beside the slow solver.
#include <mutex>

#include <gtest/gtest.h>

#include "engine/base/parallel.h"
#include "engine/math/rng.h"
#include "engine/stress/revolved_truth.h"

namespace glint::test {
namespace {

TEST(RevolvedLong, TenMillionRandomRays) {
    const auto perProfile = static_cast<int64_t>(10'000'000 / namedProfiles().size() + 1);
    RevolvedTally all;
    for (size_t i = 0; i < namedProfiles().size(); ++i) {
        const TestedProfile profile(namedProfiles()[i].object(), 1.0);
        std::mutex mutex;
        RevolvedTally sum;
        parallelChunks(perProfile, 1 << 14, 0, [&](int64_t begin, int64_t end) {
            RevolvedTally tally;
            for (int64_t ray = begin; ray < end; ++ray) {
                std::array<float, 6> u;
                for (size_t k = 0; k < u.size(); ++k) {
                    const uint64_t bits = hashCounter(i, static_cast<uint64_t>(ray) * u.size() + k);
                    u[k] = uniformFloat(static_cast<uint32_t>(bits >> 32));
                }
                compareHits(profile, profile.ray(u, ray % 3 == 0 ? 1.0 : 10.0, 1.0f), &tally);
            }
            const std::lock_guard lock(mutex);
            sum.join(tally);
        });
        EXPECT_EQ(sum.wrong, 0) << namedProfiles()[i].name << ": " << sum.firstWrong;
        all.join(sum);
    }
    EXPECT_GE(all.rays, 10'000'000);
    EXPECT_GT(all.hits, 5'000'000);
    EXPECT_LT(all.skipped, all.rays / 10);
    RecordProperty("hits", std::to_string(all.hits));
    RecordProperty("skipped", std::to_string(all.skipped));
    RecordProperty("largestErrorPartOfTolerance", std::to_string(all.largestError));
}

}  // namespace
}  // namespace glint::test
