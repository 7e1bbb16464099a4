// Photon mapping against path tracing (support/sppm_agreement.h): lights with pictures, and materials of
// several lobes.
#include "tests/support/sppm_agreement.h"
#include "tests/support/sppm_scenes.h"

namespace glint::test {
namespace {

TEST_P(SppmAgainstPaths, Projector) { expectAgreementOf(projectorBox(), finer(32000)); }
TEST_P(SppmAgainstPaths, Goniometric) { expectAgreementOf(goniometricBox(), finer(32000)); }
TEST_P(SppmAgainstPaths, Portal) { expectAgreementOf(portalBox(), params()); }
TEST_P(SppmAgainstPaths, Principled) { expectAgreementOf(principledBox(), finer(32000)); }
TEST_P(SppmAgainstPaths, Passing) { expectAgreementOf(passingBox(), finer(32000)); }
TEST_P(SppmAgainstPaths, Highlights) { expectAgreementOf(highlightBox(), finer(32000, 0.75f)); }
TEST_P(SppmAgainstPaths, Brushed) { expectAgreementOf(brushedBox(), finer(24000)); }
TEST_P(SppmAgainstPaths, Coated) { expectAgreementOf(coatedBox(), finer(24000)); }

INSTANTIATE_TEST_SUITE_P(DirectLight, SppmAgainstPaths, testing::Combine(testing::Bool(), testing::Bool()),
                         agreementModeName);

}  // namespace
}  // namespace glint::test
