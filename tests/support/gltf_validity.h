// What the specification of glTF wants of a file, beyond what a reader needs.
#pragma once

#include <string>

namespace glint::test {

/// Fails the test where tinygltf finds an error or a warning, or where the numbers of
/// accessors, normals and matrices are none that the specification allows.
void expectValidGltf(const std::string& path);

}  // namespace glint::test
