// The profiles that the stability suite knows by name, as kernels read them.
#pragma once

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "engine/builders/profile_builder.h"
#include "engine/stress/revolved_truth.h"

namespace glint::test {

inline const NamedProfile& profileNamed(const std::string& name) {
    const auto found = std::ranges::find(namedProfiles(), name, &NamedProfile::name);
    EXPECT_NE(found, namedProfiles().end()) << name;
    return *found;
}

inline ProfileTable builtProfile(const Object& object) {
    ProfileTable table;
    addProfile(object, &table);
    return table;
}

}  // namespace glint::test
