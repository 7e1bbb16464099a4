// What Mitsuba's scenes call by name.
#include <algorithm>
#include <array>
#include <string>

#include "engine/io/mitsuba_spectrum.h"

namespace glint {
namespace {

struct NamedIndex {
    std::string_view name;
    float index;
};

// At about 589 nm: Hecht 2002, "Optics", fourth edition.
constexpr NamedIndex kIndices[] = {
    {"vacuum", 1.0f},      {"helium", 1.000036f},        {"hydrogen", 1.000132f},
    {"air", 1.000277f},    {"carbon dioxide", 1.00045f}, {"water", 1.3330f},
    {"acetone", 1.36f},    {"ethanol", 1.361f},          {"carbon tetrachloride", 1.461f},
    {"glycerol", 1.4729f}, {"benzene", 1.501f},          {"silicone oil", 1.52045f},
    {"bromine", 1.661f},   {"water ice", 1.31f},         {"fused quartz", 1.458f},
    {"pyrex", 1.470f},     {"acrylic glass", 1.49f},     {"polypropylene", 1.49f},
    {"bk7", 1.5046f},      {"sodium chloride", 1.544f},  {"amber", 1.55f},
    {"pet", 1.5750f},      {"diamond", 2.419f}};

struct NamedConductor {
    std::string_view name;
    MitsubaMetal constants;
};

// The measurements of Mitsuba's files (Palik 1998, "Handbook of Optical Constants of Solids", and the SOPRA
// library), reduced as its RGB mode does: integrated against the observer as they are, so that a grey metal
// has the colour of the equal-energy white. metals.h has other ones, which keep a grey metal grey. AlAs, AlSb
// and SnTe, which Mitsuba has too, were not measured over all of the visible range.
constexpr NamedConductor kConductors[] = {
    {"a-C", {{2.9441f, 2.2271f, 1.9682f}, {0.8874f, 0.7993f, 0.8153f}}},
    {"Ag", {{0.1553f, 0.1167f, 0.1384f}, {4.8283f, 3.1222f, 2.1470f}}},
    {"Al", {{1.6575f, 0.8804f, 0.5212f}, {9.2239f, 6.2695f, 4.8370f}}},
    {"Au", {{0.1431f, 0.3750f, 1.4425f}, {3.9832f, 2.3857f, 1.6032f}}},
    {"Be", {{4.1851f, 3.1851f, 2.7841f}, {3.8354f, 3.0101f, 2.8690f}}},
    {"Cr", {{4.3697f, 2.9167f, 1.6547f}, {5.2064f, 4.2314f, 3.7549f}}},
    {"CsI", {{2.1449f, 1.7023f, 1.6624f}, Vec3(0.0f)}},
    {"Cu", {{0.2004f, 0.9240f, 1.1022f}, {3.9129f, 2.4528f, 2.1422f}}},
    {"Cu2O", {{3.5493f, 2.9521f, 2.7369f}, {0.1132f, 0.1947f, 0.6002f}}},
    {"CuO", {{3.2454f, 2.4496f, 2.1974f}, {0.5203f, 0.5707f, 0.7172f}}},
    {"Cu_palik", {{0.2127f, 0.9200f, 1.1024f}, {3.9216f, 2.4571f, 2.1367f}}},
    {"d-C", {{2.7113f, 2.3186f, 2.2289f}, Vec3(0.0f)}},
    {"Hg", {{2.3989f, 1.4400f, 0.9096f}, {6.3276f, 4.3719f, 3.4218f}}},
    {"HgTe", {{4.7795f, 3.2310f, 2.6600f}, {1.6320f, 1.5808f, 1.7296f}}},
    {"Ir", {{3.0864f, 2.0822f, 1.6179f}, {5.5922f, 4.0672f, 3.2673f}}},
    {"K", {{0.0640f, 0.0464f, 0.0382f}, {2.1042f, 1.3489f, 0.9132f}}},
    {"Li", {{0.2658f, 0.1956f, 0.2209f}, {3.5402f, 2.3111f, 1.6686f}}},
    {"MgO", {{2.0896f, 1.6507f, 1.5949f}, Vec3(0.0f)}},
    {"Mo", {{4.4837f, 3.5255f, 2.7761f}, {4.1111f, 3.4209f, 3.1506f}}},
    {"Na", {{0.0603f, 0.0561f, 0.0620f}, {3.1793f, 2.1125f, 1.5791f}}},
    {"Nb", {{3.4201f, 2.7902f, 2.3956f}, {3.4414f, 2.7376f, 2.5799f}}},
    {"Ni", {{2.3673f, 1.6634f, 1.4671f}, {4.4988f, 3.0502f, 2.3454f}}},
    {"Rh", {{2.5858f, 1.8602f, 1.5544f}, {6.7823f, 4.7030f, 3.9761f}}},
    {"Se", {{4.0593f, 2.8427f, 2.8208f}, {0.7544f, 0.6385f, 0.5216f}}},
    {"SiC", {{3.1723f, 2.5260f, 2.4794f}, Vec3(0.0f)}},
    {"Ta", {{2.0626f, 2.3931f, 2.6281f}, {2.4080f, 1.7414f, 1.9470f}}},
    {"Te", {{7.3908f, 4.4821f, 2.6371f}, {3.2561f, 3.5274f, 3.2922f}}},
    {"ThF4", {{1.8307f, 1.4422f, 1.3876f}, Vec3(0.0f)}},
    {"TiC", {{3.7005f, 2.8374f, 2.5823f}, {3.2657f, 2.3516f, 2.1728f}}},
    {"TiN", {{1.6485f, 1.1504f, 1.3798f}, {3.3685f, 1.9435f, 1.1020f}}},
    {"TiO2", {{3.4566f, 2.8017f, 2.9051f}, Vec3(0.0f)}},
    {"V", {{4.2775f, 3.5132f, 2.7611f}, {3.4912f, 2.8894f, 3.1117f}}},
    {"VC", {{3.6576f, 2.7527f, 2.5327f}, {3.0684f, 2.1987f, 1.9632f}}},
    {"VN", {{2.8656f, 2.1192f, 1.9401f}, {3.0323f, 2.0561f, 1.6163f}}},
    {"W", {{4.3707f, 3.3003f, 2.9983f}, {3.5007f, 2.6049f, 2.2732f}}}};

}  // namespace

std::optional<float> mitsubaIndex(std::string_view name) {
    std::string lower(name);
    for (char& c : lower) {
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    const auto found = std::ranges::find(kIndices, lower, &NamedIndex::name);
    return found != std::end(kIndices) ? std::optional(found->index) : std::nullopt;
}

std::optional<MitsubaMetal> mitsubaMetal(std::string_view name) {
    auto found = std::ranges::find(kConductors, name, &NamedConductor::name);
    if (found == std::end(kConductors) && name.ends_with("_palik")) {
        name.remove_suffix(6);
        found = std::ranges::find(kConductors, name, &NamedConductor::name);
    }
    return found != std::end(kConductors) ? std::optional(found->constants) : std::nullopt;
}

}  // namespace glint
