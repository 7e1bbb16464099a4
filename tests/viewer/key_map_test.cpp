// The map of keys: its table, what was chosen instead, odd preferences; and the README's table of it.
#include "viewer/model/key_map.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "engine/io/atomic_file.h"
#include "tests/viewer/play_script.h"
#include "viewer/window/key_codes.h"

namespace glint {
namespace {

using test::expectPlayed;
using test::printed;
using test::Ran;
using test::write;

TEST(KeyMap, TheTableIsInOrderAndNoKeyHasTwoActions) {
    const KeyMap keys;
    std::set<std::string> texts;
    for (size_t i = 0; i < keyActions().size(); ++i) {
        const KeyActionInfo& info = keyActions()[i];
        EXPECT_EQ(static_cast<size_t>(info.action), i);
        for (const KeyChord& chord : keys.chordsOf(info.action)) {
            EXPECT_TRUE(keyCode(chord.key)) << info.name;
            EXPECT_TRUE(keys.means(info.action, chord)) << info.name;
        }
        EXPECT_TRUE(texts.insert(keys.textOf(info.action)).second) << info.name;
    }
}

TEST(KeyMap, ShiftCountsOnlyWhereItMeansSomethingElse) {
    const KeyMap keys;
    EXPECT_TRUE(keys.means(KeyAction::FrameScene, {.shift = true, .key = "f"}));
    EXPECT_FALSE(keys.means(KeyAction::FrameSelection, {.shift = true, .key = "f"}));
    EXPECT_TRUE(keys.means(KeyAction::ZoomIn, {.shift = true, .key = "+"}));
    EXPECT_FALSE(keys.means(KeyAction::Restart, {.ctrl = true, .key = "r"}));
    EXPECT_EQ(keys.textOf(KeyAction::Redo), "Ctrl + Shift + Z, Ctrl + Y");
    EXPECT_EQ(keys.tip("Begins again", KeyAction::Restart), "Begins again (R)");
}

TEST(KeyMap, AKeyIsTakenFromWhoHadIt) {
    KeyMap keys;
    EXPECT_EQ(keys.assign(KeyAction::Pause, {.key = "j"}), "");
    EXPECT_EQ(keys.textOf(KeyAction::Pause), "J");
    const std::string note = keys.assign(KeyAction::Pause, {.key = "r"});
    EXPECT_EQ(note, "R was for \"restart\", which has no key now");
    EXPECT_EQ(keys.textOf(KeyAction::Restart), "–");
    EXPECT_EQ(keys.tip("Begins again", KeyAction::Restart), "Begins again");
    EXPECT_NE(keys.assign(KeyAction::Pause, {.key = "f1"}), "");
    EXPECT_EQ(keys.textOf(KeyAction::Pause), "R");
    EXPECT_NE(keys.reset(KeyAction::Restart), "");
    EXPECT_EQ(keys.textOf(KeyAction::Pause), "–");
    keys.resetAll();
    EXPECT_EQ(keys.textOf(KeyAction::Pause), "Space");
}

TEST(KeyMap, WhatIsChosenIsKept) {
    std::remove("kept/keys");
    KeyMap keys;
    keys.begin("kept/keys", keyNames());
    (void)keys.assign(KeyAction::Restart, {.ctrl = true, .key = "z"});  // taken from undo
    (void)keys.assign(KeyAction::Undo, {.key = "+"});
    testing::internal::CaptureStderr();
    KeyMap next;
    next.begin("kept/keys", keyNames());
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    for (const KeyActionInfo& info : keyActions()) {
        EXPECT_EQ(next.textOf(info.action), keys.textOf(info.action));
    }
    EXPECT_EQ(next.textOf(KeyAction::Undo), "+");
    EXPECT_EQ(next.textOf(KeyAction::ZoomIn), "Keypad +");
}

/// The README's table of mouse and keys, as the program has it.
std::string markdownTable() {
    std::string table = "| input | does |\n|---|---|\n";
    for (const MouseInput& each : mouseInputs()) {
        table += std::string("| ") + each.input + " | " + each.does + " |\n";
    }
    const KeyMap keys;
    for (const KeyActionInfo& info : keyActions()) {
        table += "| " + keys.textOf(info.action) + " | " + info.does + " |\n";
    }
    return table;
}

TEST(KeyMap, TheReadmeHasTheSameTable) {
    const auto readme = readFile(std::string(GLINT_SOURCE_DIR) + "/README.md");
    ASSERT_TRUE(readme);
    EXPECT_NE(readme->find(markdownTable()), std::string::npos) << markdownTable();
}

/// A session that keeps what it is told, in empty folders if `isFirst`.
Ran session(const std::string& script, bool isFirst) {
    namespace fs = std::filesystem;
    if (isFirst) {
        fs::remove_all("state");
        fs::remove_all("config");
    }
    setenv("XDG_STATE_HOME", fs::absolute("state").c_str(), 1);
    setenv("XDG_CONFIG_HOME", fs::absolute("config").c_str(), 1);
    return test::play(script, "--passes 4 --recovery 60");
}

TEST(KeyMapViewer, AKeyIsChangedInTheListAndKept) {
    const Ran first = session(R"(
wait finished
key f1
wait frames 2
expect "Key of undo" "Ctrl + Z"
click "Key of restart"
wait frames 2
expect "Key of restart" "press a key…"
key escape
wait frames 2
expect "Key of restart" R
click "Key of restart"
mark
key space
wait frames 2
expect restarts 0
expect "Key of restart" Space
expect "Key of pause" –
print "Key note"
key escape
wait frames 2
expect no-widget "Key note"
mark
key space
wait finished
expect restarts 1
)",
                              true);
    expectPlayed(first);
    EXPECT_EQ(printed(first, "Key note").at(0), "Space was for \"pause and go on\", which has no key now.");
    expectPlayed(session(R"(
wait finished
mark
key space
wait finished
expect restarts 1
key f1
wait frames 2
click "All first keys"
wait frames 2
mark
key space
wait frames 3
expect restarts 0
)",
                         false));
    EXPECT_EQ(*readFile("config/glint/keys"), "");
}

TEST(KeyMapViewer, OddPreferencesAreSaidOnce) {
    std::filesystem::remove_all("config");
    std::filesystem::create_directories("config/glint");
    write("config/glint/keys",
          "# mine\nundoo ctrl+u\npause hyper\nrestart j\nkeep j\nrestart u\nflip ctrl+z\n");
    const Ran ran = session(R"(
wait finished
key f1
wait frames 2
expect "Key of restart" J
expect "Key of pause" Space
expect "Key of keep" K
expect "Key of flip" "Ctrl + Z"
expect "Key of undo" –
)",
                            false);
    expectPlayed(ran);
    EXPECT_NE(ran.output.find("keys:2: there is no action 'undoo' (did you mean 'undo'?); 4 more lines"),
              std::string::npos)
        << ran.output;
}

}  // namespace
}  // namespace glint
