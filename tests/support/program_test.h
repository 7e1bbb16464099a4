// What tests of the built program share: a folder of their own, and a look at what it says.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "tests/support/run_program.h"
#include "tests/support/temp_folder.h"

namespace glint::test {

/// Skips where the program was not built.
class ProgramTest : public testing::Test {
  protected:
    void SetUp() override {
        if (!programExists()) { GTEST_SKIP() << "the program was not built"; }
    }
    TempFolder folder;
};

inline testing::AssertionResult says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos
               ? testing::AssertionSuccess()
               : testing::AssertionFailure() << "'" << part << "' is not in: " << text;
}

}  // namespace glint::test
