// A file whose right to write was taken away is kept, also in a folder where it could be replaced.
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "engine/io/atomic_file.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
using test::TempFolder;
using testing::HasSubstr;
using testing::StartsWith;

/// Root may write to anything: it becomes nobody while this lives.
class Nobody {
  public:
    Nobody() {
        if (::geteuid() == 0) { isNobody_ = ::seteuid(65534) == 0; }
    }
    ~Nobody() {
        if (isNobody_) { EXPECT_EQ(::seteuid(0), 0); }
    }
    Nobody(const Nobody&) = delete;
    Nobody& operator=(const Nobody&) = delete;

  private:
    bool isNobody_ = false;
};

TEST(ReadOnlyFile, IsNotReplaced) {
    const TempFolder folder;
    const std::string path = folder.path("mine.json");
    ASSERT_TRUE(writeFileAtomically(path, "kept"));
    // So that nobody gets there: the test's program has a folder around it.
    const fs::path around = fs::path(folder.path()).parent_path();
    ASSERT_THAT(around.filename().string(), StartsWith("glint-test-"));
    ASSERT_EQ(::chmod(around.c_str(), 0711), 0);
    ASSERT_EQ(::chmod(folder.path().c_str(), 0777), 0);
    ASSERT_EQ(::chmod(path.c_str(), 0444), 0);
    {
        const Nobody nobody;
        const Status refused = writeFileAtomically(path, "new");
        ASSERT_FALSE(refused);
        EXPECT_THAT(refused.error().format(), HasSubstr("mine.json: cannot write: Permission denied"));
        EXPECT_FALSE(checkWritable(path)) << "a render says so at its beginning";
        EXPECT_TRUE(writeFileAtomically(folder.path("other.json"), "new"));
    }
    EXPECT_EQ(*readFile(path), "kept");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 2);
}

}  // namespace
}  // namespace glint
