// A scene that would be white gets an exposure when it is opened, which is the user's from then on.
#include <gtest/gtest.h>

#include "tests/viewer/play_script.h"

namespace glint {
namespace {

/// The environment alone, of that radiance.
void writeScene(const std::string& name, const std::string& radiance) {
    test::write(name, R"({"glint": 1, "resolution": [64, 48], "environment": {"color": )" + radiance + "}}");
}

TEST(ExposureViewer, IsChosenWhenAWhiteSceneOpensAndNotForOneThatShows) {
    writeScene("white.json", "40");
    writeScene("plain.json", "0.5");
    test::write("chosen.txt",
                "wait picture\nopen \"Display\"\nwait frames 2\nexpect \"Exposure\" -5.6666665\n"
                "set \"Exposure\" 1\nwait frames 2\nexpect \"Exposure\" 1\n");
    test::expectPlayed(test::run("view white.json --headless --threads 1 --script chosen.txt"));
    test::write("zero.txt", "wait picture\nopen \"Display\"\nwait frames 2\nexpect \"Exposure\" 0\n");
    test::expectPlayed(test::run("view plain.json --headless --threads 1 --script zero.txt"));
    test::expectPlayed(
        test::run("view white.json --headless --threads 1 --no-auto-exposure --script zero.txt"));
}

}  // namespace
}  // namespace glint
