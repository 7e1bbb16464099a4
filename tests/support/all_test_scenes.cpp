// The list of all test scenes.
#include "tests/support/sppm_scenes.h"
#include "tests/support/test_scenes.h"

namespace glint::test {

std::vector<NamedScene> allTestScenes() {
    return {{"cornellBox", cornellBox()},
            {"allMaterials", allMaterials()},
            {"texturedInputs", texturedInputs()},
            {"meshInstances", meshInstances()},
            {"manyLights", manyLights()},
            {"lampShapes", emitterShapes()},
            {"whiteFurnace", whiteFurnace()},
            {"darkness", darkness()},
            {"turnedProfiles", turnedProfiles()},
            {"reliefs", reliefs()},
            {"kdTrees", kdTrees()},
            {"dispersiveBalls", dispersiveBalls()},
            {"absorbingGlass", absorbingGlassBox()},
            {"translucentSheets", translucentBox()},
            {"principled", principledBox()},
            {"passing", passingBox()},
            {"highlights", highlightBox()},
            {"coated", coatedBox()},
            {"projector", projectorBox()},
            {"goniometric", goniometricBox()},
            {"portal", portalBox()}};
}

}  // namespace glint::test
