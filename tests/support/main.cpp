// Every test program runs in a temporary folder of its own, which goes with what the tests left in it.
#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>

#include "tests/support/temp_folder.h"

int main(int argc, char** argv) {
    testing::InitGoogleMock(&argc, argv);
    const glint::test::TempFolder folder;
    std::filesystem::current_path(folder.path());
    setenv("TMPDIR", folder.path().c_str(), 1);
    setenv("TEST_TMPDIR", folder.path().c_str(), 1);  // GoogleTest's own
    return RUN_ALL_TESTS();
}
