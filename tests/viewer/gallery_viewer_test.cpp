// What an empty window offers.
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/viewer/play_script.h"
#include "viewer/model/example_scenes.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
using namespace test;
using testing::HasSubstr;

TEST(ExampleScenes, HaveTheirTitlesAndThumbnails) {
    fs::create_directories("examples");
    fs::create_directories("assets/scenes");
    write("examples/b.json", "{ // a comment\n\"glint\": 1, \"title\": \"The second\" }");
    write("examples/a.json", "broken");
    write("examples/glint.schema.json", "{}");
    write("assets/scenes/b.jpg", "no picture");
    const auto examples = listExamples("examples");
    ASSERT_EQ(examples.size(), 2u);
    EXPECT_EQ(examples[0].title, "a");
    EXPECT_EQ(examples[1].title, "The second");
    EXPECT_TRUE(examples[1].thumbnail.rgba.empty());
    EXPECT_TRUE(listExamples("nowhere").empty());
}

TEST(ExampleScenes, ThoseOfTheProgramHaveThumbnails) {
    size_t thumbnails = 0;
    for (const ExampleScene& example : listExamples(GLINT_SOURCE_DIR "/scenes")) {
        thumbnails += example.thumbnail.rgba.empty() ? 0 : 1;
    }
    EXPECT_GT(thumbnails, 10u);
}

TEST(GalleryViewer, AnEmptyWindowOffersTheExamplesAndOpensOne) {
    write("empty.txt", R"(
wait jobs
wait frames 4
screenshot gallery.png
print "Example furnace"
click "Example furnace"
wait jobs
wait picture
expect no-widget "Example furnace"
expect no-error
)");
    const Ran ran = run("view --headless --threads 1 --size 1280x720 --passes 1 --script empty.txt");
    expectPlayed(ran);
    EXPECT_THAT(ran.output, HasSubstr("urnace"));
}

}  // namespace
}  // namespace glint
