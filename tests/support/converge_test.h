// What tests of `glint converge` share: runs over one small scene, and what they wrote.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/support/program_test.h"

namespace glint::test {

const std::string kConvergeScene = GLINT_SOURCE_DIR "/scenes/cornell.json";

class ConvergeCommand : public ProgramTest {
  protected:
    /// With the scene first and a folder last.
    ProgramRun converge(std::vector<std::string> options, const std::string& out = "run",
                        const std::string& interruptAfter = {}) {
        std::vector<std::string> words = {"converge", kConvergeScene, "--size", "16x12"};
        words.insert(words.end(), options.begin(), options.end());
        words.insert(words.end(), {"--out", folder.path(out)});
        return runProgram(words, {.signalAfter = interruptAfter});
    }
    std::string file(const std::string& name, const std::string& out = "run") const {
        return folder.path(out + "/" + name);
    }
    nlohmann::json summary(const std::string& out = "run") const {
        return nlohmann::json::parse(TempFolder::read(file("summary.json", out)), nullptr, false);
    }
    void removeResults() const {
        for (const char* name :
             {"index.html", "summary.json", "curve.csv", "summary.csv", "plot.svg", "plot.png", "pictures"}) {
            std::filesystem::remove_all(file(name));
        }
    }

    const std::vector<std::string> small = {"--make-reference", "0.2", "--passes", "6",
                                            "--points",         "4",   "--seeds",  "2"};
    std::vector<std::string> with(std::vector<std::string> more) const {
        std::vector<std::string> all = small;
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
};

}  // namespace glint::test
