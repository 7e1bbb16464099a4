// The fields of every scene type, each listed once. A field that is added to a type is a line here.
#pragma once

#include "engine/scene/field.h"
#include "engine/scene/generated_mesh.h"
#include "engine/scene/glasses.h"
#include "engine/scene/metals.h"

namespace glint {

constexpr double kLargestUint32 = 4294967295.0;
constexpr NumberRange kViewAngle{
    .lo = 0.0, .hi = 180.0, .openLo = true, .openHi = true, .expected = "an angle between 0 and 180 degrees"};
constexpr NumberRange kFilterRadius{
    .lo = 0.0, .hi = 16.0, .openLo = true, .expected = "a radius above 0 and up to 16 pixels"};
constexpr NumberRange kAlphaRange{
    .lo = 0.0, .hi = 1.0, .openLo = true, .openHi = true, .expected = "a number between 0 and 1"};
constexpr NumberRange kRadiusRange{
    .lo = 0.0, .hi = double{1e18f}, .expected = "a radius in metres, or 0 for an automatic one"};
constexpr NumberRange kFootprintRange{
    .lo = 0.0, .hi = 1e6, .openLo = true, .expected = "a number above 0 and up to 1e6"};
constexpr NumberRange kReflectance{.lo = 0.0, .hi = 1.0, .expected = "a reflectance from 0 to 1 per channel"};
constexpr NumberRange kExponent{.lo = double{0.01f}, .hi = 100.0, .expected = "an exponent from 0.01 to 100"};
constexpr NumberRange kIor{
    .lo = double{0.01f}, .hi = 100.0, .expected = "an index of refraction from 0.01 to 100"};
constexpr NumberRange kAbbeNumber{
    .lo = 0.0, .hi = 1000.0, .expected = "an Abbe number up to 1000, or 0 for none"};
constexpr NumberRange kPhongExponent{.lo = 0.0, .hi = 1e8, .expected = "an exponent from 0 to 1e8"};
constexpr NumberRange kShininess{.lo = 0.0, .hi = 1e6, .expected = "an exponent from 0 to 1e6"};
constexpr NumberRange kConeAngle{
    .lo = 0.0, .hi = 90.0, .openLo = true, .expected = "a half angle above 0 and up to 90 degrees"};
constexpr NumberRange kConeStart{
    .lo = 0.0, .hi = 90.0, .expected = "a half angle from 0 to \"coneAngleDeg\""};
constexpr NumberRange kElevation{.lo = -90.0, .hi = 90.0, .expected = "an angle from -90 to 90 degrees"};
constexpr NumberRange kSunRadius{
    .lo = double{0.1f}, .hi = 90.0, .expected = "an angle from 0.1 to 90 degrees"};

template <>
struct FieldsOf<Camera> {
    static constexpr EditKind kEdit = EditKind::Camera;
    static constexpr FieldList kList{
        field("position", &Camera::position,
              {.unit = "m", .help = "where the camera stands", .option = "--camera-position"}),
        field("target", &Camera::target,
              {.unit = "m", .help = "a point the camera looks at", .option = "--camera-target"}),
        field("up", &Camera::up, {.form = VectorForm::Direction}),
        field("projection", &Camera::kind,
              {.help = "perspective, or parallel rays: orthographic", .onlyIfSet = true}),
        field("verticalFovDeg", &Camera::verticalFovDeg,
              {.range = kViewAngle,
               .unit = "degrees",
               .help = "full vertical angle of view; of perspective alone",
               .option = "--fov"}),
        field("viewHeight", &Camera::viewHeight,
              {.range = kPositive,
               .unit = "m",
               .help = "height of what an orthographic picture shows",
               .kinds = only(ProjectionKind::Orthographic),
               .onlyOwnKinds = true}),
        field("horizontalScale", &Camera::horizontalScale,
              {.range = kPositive, .help = "widens (> 1) or narrows the view: non-square pixels"}),
        field("shift", &Camera::shift,
              {.help = "where the picture's middle lies right of and above the view axis, in heights of the "
                       "picture: a shifted lens, or a crop window",
               .onlyIfSet = true}),
        field("apertureDiameter", &Camera::apertureDiameter,
              {.range = kNotNegative,
               .unit = "m",
               .help = "aperture's diameter; 0: a pinhole, everything is sharp",
               .option = "--aperture"}),
        field("focalDistance", &Camera::focalDistance,
              {.range = kPositive,
               .unit = "m",
               .help = "distance of the plane in focus; the target's where a scene leaves it out",
               .option = "--focus"},
              {.setDefault =
                   [](Camera* camera) {
                       camera->focalDistance = glm::length(camera->target - camera->position);
                   }}),
        field("apertureBlades", &Camera::apertureBlades,
              {.range = {.lo = 0, .hi = 64}, .help = "0: a round aperture, otherwise its corners"},
              {.holds =
                   [](const Camera& camera) {
                       return camera.apertureBlades != 1 && camera.apertureBlades != 2;
                   },
               .message = "\"apertureBlades\" is less than 3; expected 0 (round) or 3 to 64"}),
        field("bladeRotationDeg", &Camera::bladeRotationDeg,
              {.unit = "degrees", .help = "turns the aperture's corners; at 0 one lies to the right"})};
};

template <>
struct FieldsOf<Resolution> {
    static constexpr EditKind kEdit = EditKind::Resolution;
    static constexpr FieldList kList{
        field("width", &Resolution::width, {.range = {.lo = 1, .hi = 32768}, .unit = "pixels"}),
        field("height", &Resolution::height, {.range = {.lo = 1, .hi = 32768}, .unit = "pixels"})};
};

#define GLINT_KEY_AND_HELP(kind, key, alias, displayName, help) "; " key ": " help
template <>
struct FieldsOf<RenderOptions> {
    static constexpr EditKind kEdit = EditKind::Options;
    static constexpr FieldList kList{
        field("integrator", &RenderOptions::integrator,
              {.help = "the algorithm" GLINT_INTEGRATORS(GLINT_KEY_AND_HELP),
               .edit = EditKind::Integrator,
               .option = "--integrator"}),
        field("maxDepth", &RenderOptions::maxDepth,
              {.range = {.lo = 0, .hi = 1 << 20},
               .help = "most scattering events along a path; of photons at most 256",
               .option = "--depth"}),
        field("rouletteStartDepth", &RenderOptions::rouletteStartDepth,
              {.range = {.lo = 0, .hi = 1 << 20},
               .help = "the scattering event Russian roulette starts at",
               .variant = "roulette"}),
        field("filter", &RenderOptions::filter, {.help = "reconstruction filter", .option = "--filter"}),
        field("filterRadiusPixels", &RenderOptions::filterRadius,
              {.range = kFilterRadius,
               .unit = "pixels",
               .help = "half the filter's width",
               .setting = "filterRadius",
               .option = "--filter-radius"},
              {.setDefault =
                   [](RenderOptions* options) { options->filterRadius = usualRadius(options->filter); }}),
        field("sampler", &RenderOptions::sampler,
              {.help = "points: sobol (low discrepancy) or independent",
               .option = "--sampler",
               .variant = "sampler"}),
        field("accelerator", &RenderOptions::accelerator,
              {.help = "what rays find objects and triangles by; changes the time alone",
               .edit = EditKind::Accelerator,
               .inFingerprint = false,
               .option = "--accelerator",
               .variant = "accelerator"}),
        field("seed", &RenderOptions::seed,
              {.range = {.lo = 0, .hi = kLargestUint32},
               .help = "seed of the random numbers",
               .option = "--seed"}),
        field("fireflyClamp", &RenderOptions::fireflyClamp,
              {.range = kNotNegative,
               .help = "the most radiance a sample may bring, biased; 0: off",
               .variant = "clamp"})};
};
#undef GLINT_KEY_AND_HELP

template <>
struct FieldsOf<SppmOptions> {
    static constexpr const char* kHelp =
        "Stochastic progressive photon mapping, for the integrator \"sppm\".";
    static constexpr EditKind kEdit = EditKind::SppmParameters;
    static constexpr FieldList kList{
        field("photonsPerPass", &SppmOptions::photonsPerPass,
              {.range = {.lo = 1, .hi = 1 << 30},
               .help = "photons in a pass",
               .option = "--photons",
               .variant = "photons"}),
        field("alpha", &SppmOptions::alpha,
              {.range = kAlphaRange,
               .help = "share of each pass's photons that is kept: smaller shrinks radii faster",
               .option = "--alpha",
               .variant = "alpha"}),
        field("radius", &SppmOptions::radiusWorld,
              {.range = kRadiusRange,
               .unit = "m",
               .help = "first radius; 0: automatic, from each pixel's footprint"}),
        field("radiusFootprints", &SppmOptions::radiusFootprints,
              {.range = kFootprintRange,
               .help = "automatic: first radius in widths of a pixel where it meets the surface"}),
        field("storeRoughness", &SppmOptions::storeRoughness,
              {.range = kUnitInterval,
               .help =
                   "metal and glass at least this rough gather photons; sharper ones reflect or refract on"}),
        field("directLight", &SppmOptions::sampleDirectLight,
              {.help = "direct light: sampled, or left to the photons",
               .option = "--direct",
               .variant = "direct",
               .whenTrue = "sampled",
               .whenFalse = "photons"}),
        field("lookup", &SppmOptions::lookup,
              {.help = "how photons are found: hash grid or kd-tree",
               .option = "--lookup",
               .variant = "lookup"}),
        field("memoryBudgetMiB", &SppmOptions::memoryBudgetMiB,
              {.range = {.lo = 0, .hi = 1 << 22},
               .unit = "MiB",
               .help = "budget for photons and statistics: photons in a pass are reduced to fit; 0: no limit",
               .option = "--memory"})};
};

template <>
struct FieldsOf<RayCastOptions> {
    static constexpr const char* kHelp =
        "Phong's model under the scene's lights, for the integrator \"raycast\".";
    static constexpr EditKind kEdit = EditKind::RayCastParameters;
    static constexpr FieldList kList{
        field("shadows", &RayCastOptions::shadows,
              {.help = "whether lights cast shadows",
               .option = "--phong-shadows",
               .whenTrue = "on",
               .whenFalse = "off"}),
        field(
            "falloff", &RayCastOptions::falloff,
            {.help = "on: point and spot lights fall off with distance; off: they shine everywhere as at the "
                     "scene's middle",
             .option = "--phong-falloff",
             .whenTrue = "on",
             .whenFalse = "off"}),
        field("ambient", &RayCastOptions::ambient,
              {.range = kNotNegative,
               .form = VectorForm::Color,
               .unit = "W/(sr m^2)",
               .help = "light from all around, which nothing shades"})};
};

template <>
struct FieldsOf<Texture> {
    static constexpr EditKind kEdit = EditKind::MaterialKind;
    static constexpr uint32_t kInFile = 1u << 0, kGenerated = 1u << 1;  ///< kinds
    static constexpr FieldList kList{
        label("", &Texture::name),
        field("file", &Texture::image,
              {.help = "PNG, JPEG, BMP, TGA, TIFF, WebP, DDS, HDR or EXR; relative to the scene's folder",
               .kinds = kInFile,
               .required = true},
              {.isSaved = [](const Texture& texture) { return !texture.image.isGenerated(); }}),
        field("encoding", &Texture::encoding, {.help = "how 8-bit files hold colour"}),
        field("flipV", &Texture::flipV, {.help = "counts v from the image's top row"}),
        field("scale", &Texture::scale, {.help = "factors on u and v"}),
        field("rotationDeg", &Texture::rotationDeg,
              {.unit = "degrees", .help = "turns u and v counter-clockwise, after the scale"}),
        field("offset", &Texture::offset, {.help = "added to u and v, after the turn"}),
        field("wrapU", &Texture::wrapU, {.help = "what is shown left and right of the image"}),
        field("wrapV", &Texture::wrapV, {.help = "what is shown above and below the image"}),
        field("filter", &Texture::filter,
              {.help = "between the centres of texels; mipmap: the mean over what a pixel covers"}),
        field("channel", &Texture::channel, {.help = "what stands for a single number", .onlyIfSet = true}),
        field("base", &Texture::base,
              {.help = "what black becomes: (base + gain x)^exponent stands for x", .onlyIfSet = true}),
        field("gain", &Texture::gain, {.help = "factor on what the image holds", .onlyIfSet = true}),
        field("exponent", &Texture::exponent, {.range = kExponent, .onlyIfSet = true})};
};

template <>
struct FieldsOf<Checkerboard> {
    static constexpr EditKind kEdit = EditKind::MaterialKind;
    static constexpr FieldTraits kSquare{
        .range = kNotNegative, .form = VectorForm::Color, .inFingerprint = false};
    static constexpr FieldList kList{field("even", &Checkerboard::even, kSquare),
                                     field("odd", &Checkerboard::odd, kSquare)};
};

/// Whether `color` is a factor on a reflectance that is there without it.
constexpr bool isTinted(MaterialKind kind) {
    return kind == MaterialKind::Mirror || kind == MaterialKind::Conductor ||
           kind == MaterialKind::Dielectric || kind == MaterialKind::Coated;
}

/// The field of an input that material_inputs.h describes.
template <class MemberIn>
constexpr auto inputField(const ModelInput<MemberIn>& described) {
    const auto member = described.memberIn(TypeTag<Material>());
    using Input = std::remove_cvref_t<decltype(std::declval<Material>().*member)>;
    constexpr bool kIsColor = std::is_same_v<Input, ColorInput>;
    return field<Material, Input>(described.info.key, member,
                                  {.range = kIsColor ? kReflectance : kUnitInterval,
                                   .isColor = kIsColor,
                                   .help = described.info.help,
                                   .kinds = described.info.kinds,
                                   .onlyOwnKinds = true});
}

template <>
struct FieldsOf<Material> {
    static constexpr EditKind kEdit = EditKind::MaterialParameters;
    static constexpr uint32_t kMetal = only(MaterialKind::Conductor, MaterialKind::Coated);
    static constexpr uint32_t kRefractive =
        only(MaterialKind::Dielectric, MaterialKind::Plastic, MaterialKind::Mixture, MaterialKind::Principled,
             MaterialKind::Coated);
    static constexpr uint32_t kGlass = only(MaterialKind::Dielectric, MaterialKind::Mixture);
    static constexpr uint32_t kRough =
        only(MaterialKind::Conductor, MaterialKind::Dielectric, MaterialKind::Plastic,
             MaterialKind::Principled, MaterialKind::Ward, MaterialKind::Coated);
    static constexpr uint32_t kFacets =
        only(MaterialKind::Conductor, MaterialKind::Dielectric, MaterialKind::Plastic, MaterialKind::Coated);
    static constexpr uint32_t kPrincipled = only(MaterialKind::Principled);
    static constexpr auto kList = withDescribedInputs([](const auto&... described) {
        return FieldList{
            field("type", &Material::kind, {.edit = EditKind::MaterialKind, .required = true}),
            label("", &Material::name),
            field("color", &Material::color,
                  {.range = kReflectance, .isColor = true, .help = "reflectance; conductor: a factor on it"},
                  {.setDefault =
                       [](Material* material) {
                           material->color.value = Vec3(isTinted(material->kind) ? 1.0f : 0.5f);
                       }}),
            field("metal", &Material::metal,
                  {.help = "measured constants", .kinds = kMetal, .words = metalNames},
                  {.isSaved = [](const Material& material) { return !material.metal.empty(); }}),
            field<Material, ColorInput>(
                "eta", &Material::eta,
                {.range = kPositive, .help = "index of refraction, grey or [r, g, b]", .kinds = kMetal},
                {.isSaved = [](const Material& material) { return material.metal.empty(); }}),
            field<Material, ColorInput>(
                "k", &Material::k,
                {.range = kNotNegative, .help = "extinction, grey or [r, g, b]", .kinds = kMetal},
                {.isSaved = [](const Material& material) { return material.metal.empty(); }}),
            field("glass", &Material::glass,
                  {.help = "measured indices by wavelength",
                   .kinds = kGlass,
                   .onlyOwnKinds = true,
                   .words = glassNames},
                  {.isSaved = [](const Material& material) { return !material.glass.empty(); }}),
            field("iorRgb", &Material::iorRgb,
                  {.range = kNotNegative,
                   .form = VectorForm::Color,
                   .help = "indices at red, green and blue; the picture then has three wavelengths; 0: ior",
                   .kinds = kGlass,
                   .onlyOwnKinds = true},
                  {.isSaved =
                       [](const Material& material) {
                           return material.glass.empty() && !isZero(material.iorRgb);
                       }}),
            field<Material, NumberInput>(
                "ior", &Material::ior,
                {.range = kIor, .help = "index of refraction inside over outside", .kinds = kRefractive},
                {.isSaved = [](const Material& material) { return !replacesIor(material); }}),
            field("abbeNumber", &Material::abbeNumber,
                  {.range = kAbbeNumber,
                   .help = "dispersion of ior: 20 bends colours far apart, 80 hardly; 0: none",
                   .kinds = kGlass,
                   .onlyOwnKinds = true},
                  {.isSaved = [](const Material& material) { return !replacesIor(material); }}),
            field<Material, NumberInput>(
                "roughness", &Material::roughness,
                {.range = kUnitInterval,
                 .help = "alpha of the facets; 0: smooth. Along u where crossRoughness is given",
                 .kinds = kRough},
                {.setDefault =
                     [](Material* material) {
                         if (material->kind == MaterialKind::Ward) { material->roughness.value = 0.1f; }
                     }}),
            field<Material, NumberInput>(
                "crossRoughness", &Material::crossRoughness,
                {.range = kUnitInterval,
                 .help = "alpha across u, of brushed surfaces; left out: as roughness",
                 .kinds = kRough,
                 .onlyIfSet = true},
                {.isSaved = hasCrossRoughness}),
            field(
                "anisotropyRotationDeg", &Material::anisotropyRotationDeg,
                {.unit = "degrees",
                 .help = "turns the direction of roughness from u towards v",
                 .kinds = kRough,
                 .onlyIfSet = true},
                {.isSaved = [](const Material& material) { return material.anisotropyRotationDeg != 0.0f; }}),
            field<Material, ColorInput>(
                "anisotropyDirection", &Material::anisotropyDirection,
                {.range = kUnitInterval,
                 .help = "a texture of that direction: x to the image's right, y to its top, 0.5 is 0",
                 .kinds = kRough,
                 .onlyIfSet = true},
                {.isSaved =
                     [](const Material& material) {
                         return material.anisotropyDirection != Material{}.anisotropyDirection;
                     }}),
            field("distribution", &Material::distribution,
                  {.help = "of the facets: ggx has long tails, beckmann none",
                   .kinds = kFacets,
                   .onlyIfSet = true}),
            field("thin", &Material::thin,
                  {.help = "a sheet of no thickness: light passes straight",
                   .kinds = only(MaterialKind::Dielectric, MaterialKind::Principled)}),
            field("attenuationColor", &Material::attenuationColor,
                  {.range = kReflectance,
                   .form = VectorForm::Color,
                   .help = "what is left of light after attenuationDistance inside glass that is not thin",
                   .kinds = only(MaterialKind::Dielectric, MaterialKind::Principled),
                   .onlyIfSet = true}),
            field("attenuationDistance", &Material::attenuationDistance,
                  {.range = kPositive,
                   .unit = "m",
                   .help = "way inside the glass that leaves attenuationColor",
                   .kinds = only(MaterialKind::Dielectric, MaterialKind::Principled),
                   .onlyIfSet = true}),
            field<Material, ColorInput>("transmission", &Material::transmission,
                                        {.range = kReflectance,
                                         .isColor = true,
                                         .help = "what passes, diffusely; with the colour at most 1",
                                         .kinds = only(MaterialKind::Translucent),
                                         .onlyOwnKinds = true}),
            field<Material, ColorInput>(
                "specularReflectance", &Material::specularReflectance,
                {.range = kReflectance,
                 .isColor = true,
                 .help = "of the highlight; with the colour at most 1, or both are scaled",
                 .kinds = only(MaterialKind::Phong, MaterialKind::Ward),
                 .onlyOwnKinds = true}),
            field<Material, NumberInput>("exponent", &Material::exponent,
                                         {.range = kPhongExponent,
                                          .help = "of the highlight: larger is narrower",
                                          .kinds = only(MaterialKind::Phong),
                                          .onlyOwnKinds = true}),
            field("variant", &Material::wardForm,
                  {.help = "ward: as of 1992; ward-duer: of 2006; balanced: of 2010, bounded by itself",
                   .kinds = only(MaterialKind::Ward),
                   .onlyOwnKinds = true}),
            field<Material, ColorInput>(
                "coatAbsorption", &Material::coatAbsorption,
                {.range = kNotNegative,
                 .help = "optical depth straight through the coat: absorption per metre times thickness",
                 .kinds = only(MaterialKind::Coated),
                 .onlyOwnKinds = true}),
            field<Material, NumberInput>(
                "metallic", &Material::metallic,
                {.range = kUnitInterval,
                 .help = "0: plastic over the colour; 1: a metal that reflects the colour",
                 .kinds = kPrincipled,
                 .onlyOwnKinds = true}),
            field<Material, NumberInput>(
                "specularTransmission", &Material::specularTransmission,
                {.range = kUnitInterval,
                 .help = "share of what enters plastic that passes it instead of being "
                         "scattered; thin: straight, else with refraction",
                 .kinds = kPrincipled,
                 .onlyOwnKinds = true,
                 .onlyIfSet = true}),
            field("rootTint", &Material::rootTint,
                  {.help = "what passes is tinted by the root of the colour: in and out by the colour",
                   .kinds = kPrincipled,
                   .onlyOwnKinds = true,
                   .onlyIfSet = true}),
            inputField(described)...,
            field<Material, ColorInput>(
                "weights", &Material::mixtureWeights,
                {.range = kNotNegative,
                 .help = "[diffuse, mirror, refractive], in any unit",
                 .kinds = only(MaterialKind::Mixture)},
                {.holds = [](const Material& material) { return !isZero(material.mixtureWeights.value); },
                 .message = "\"weights\" are all 0; expected [diffuse, mirror, refractive]"}),
            field("bump", &Material::bump,
                  {.help = "a texture of heights, over which shading normals lean", .onlyIfSet = true}),
            field("bumpHeight", &Material::bumpHeight,
                  {.unit = "m", .help = "what a height of 1 stands for", .onlyIfSet = true}),
            field(
                "normalMap", &Material::normalMap,
                {.range = kUnitInterval,
                 .help = "a texture of tangent-space normals: x to the image's right, y to its top, 0.5 is 0",
                 .onlyIfSet = true}),
            field("normalStrength", &Material::normalStrength,
                  {.help = "factor on x and y of the normal map", .onlyIfSet = true}),
            field("opacity", &Material::opacity,
                  {.range = kUnitInterval,
                   .help = "share of the surface that is there; of a texture its alpha, or else its channel",
                   .onlyIfSet = true}),
            field("alphaCutsOut", &Material::alphaCutsOut,
                  {.help = "the alpha of the colour's image is a factor on the opacity", .onlyIfSet = true}),
            field("emission", &Material::emission,
                  {.range = kNotNegative, .isColor = true, .unit = "W/(sr m^2)", .help = "radiance"}),
            field("emissionStrength", &Material::emissionStrength,
                  {.range = kNotNegative, .help = "factor on emission"}),
            field("emitsBothSides", &Material::emitsBothSides,
                  {.help = "otherwise only the front side shines"}),
            field("specularColor", &Material::phongSpecular,
                  {.range = kNotNegative,
                   .form = VectorForm::Color,
                   .help = "of Phong's highlights, in ray casting alone",
                   .edit = EditKind::RayCastParameters,
                   .inFingerprintIfSaved = true},
                  {.isSaved = [](const Material& material) { return !isZero(material.phongSpecular); }}),
            field("shininess", &Material::phongExponent,
                  {.range = kShininess,
                   .help = "exponent of Phong's highlights, in ray casting alone: larger is smaller",
                   .edit = EditKind::RayCastParameters,
                   .inFingerprintIfSaved = true},
                  {.isSaved = [](const Material& material) { return !isZero(material.phongSpecular); }})};
    });
};

/// Of a mesh. What the picture depends on are the triangles.
template <>
struct FieldsOf<FileSource> {
    static constexpr EditKind kEdit = EditKind::None;
    static constexpr FieldList kList{
        field("file", &FileSource::path,
              {.help = "OBJ, PLY or STL; relative to the scene's folder",
               .inFingerprint = false,
               .required = true}),
        field("part", &FileSource::part,
              {.range = {.lo = 0, .hi = 100'000'000},
               .help = "the file's n-th part, from 0 (OBJ: a run of faces of one material; PLY has one "
                       "part); all of "
                       "them if left out",
               .inFingerprint = false},
              {.isSaved = [](const FileSource& file) { return file.part >= 0; }}),
        field("faceted", &FileSource::isFaceted,
              {.help = "triangles without normals stay flat; otherwise they get smooth ones",
               .inFingerprint = false},
              {.isSaved = [](const FileSource& file) { return file.isFaceted; }})};
};

template <>
struct FieldsOf<MeshGenerator> {
    static constexpr EditKind kEdit = EditKind::None;
    static constexpr FieldList kList{
        field("generator", &MeshGenerator::name,
              {.inFingerprint = false, .required = true, .words = meshGeneratorNames}),
        field("triangleCount", &MeshGenerator::triangles,
              {.range = {.lo = 1, .hi = 100'000'000},
               .help = "about how many; 10000 if left out",
               .inFingerprint = false},
              {.setDefault = [](MeshGenerator* generator) { generator->triangles = 10000; }}),
        field("seed", &MeshGenerator::seed,
              {.range = {.lo = 0, .hi = kLargestUint32}, .inFingerprint = false})};
};

template <>
struct FieldsOf<Mesh> {
    static constexpr EditKind kEdit = EditKind::Everything;
    static constexpr FieldList kList{label("", &Mesh::name), label("", &Mesh::source),
                                     field("", &Mesh::data)};
};

/// Beside these keys stand those of shape_forms.h.
template <>
struct FieldsOf<Object> {
    static constexpr EditKind kEdit = EditKind::Everything;
    static constexpr FieldList kList{
        field("type", &Object::shape, {.required = true}),
        label("name", &Object::name),
        field("", &Object::mesh),
        field("curve", &Object::curve,
              {.help = "how the points make the profile",
               .kinds = only(ShapeKind::Revolved),
               .onlyOwnKinds = true}),
        field("degree", &Object::curveDegree,
              {.range = {.lo = 0.0, .hi = 15.0},
               .help = "of the Bézier curves that the points make one after the other; 0: one curve of all",
               .kinds = only(ShapeKind::Revolved),
               .onlyOwnKinds = true}),
        field("profile", &Object::profile,
              {.unit = "m",
               .help = "points [distance from the y axis, height] of the curve that turns about that axis",
               .kinds = only(ShapeKind::Revolved),
               .required = true,
               .onlyOwnKinds = true}),
        field("caps", &Object::capped,
              {.help = "discs close the surface where the profile ends off the axis",
               .kinds = only(ShapeKind::Revolved),
               .onlyOwnKinds = true,
               .onlyIfSet = true}),
        field("clampedSearch", &Object::clampsSearch,
              {.help = "rays meet what one search finds that is kept on the curve: a known bug, to see it",
               .kinds = only(ShapeKind::Revolved),
               .onlyOwnKinds = true,
               .onlyIfSet = true}),
        field("material", &Object::material,
              {.help = "a material's name, or the material itself", .custom = true}),
        field("frontOnly", &Object::frontOnly, {.help = "rays meet only the front side"}),
        field("transform", &Object::objectToWorld, {.edit = EditKind::ObjectTransform, .custom = true})};
};

template <>
struct FieldsOf<Light> {
    static constexpr EditKind kEdit = EditKind::Lights;
    static constexpr uint32_t kSpot = only(LightKind::Spot);
    static constexpr uint32_t kProjector = only(LightKind::Projector);
    static constexpr uint32_t kPlaced = only(LightKind::Point, LightKind::Spot, LightKind::Goniometric);
    static constexpr uint32_t kWithImage = only(LightKind::Projector, LightKind::Goniometric);
    static constexpr FieldList kList{
        field("type", &Light::kind, {.required = true}),
        label("name", &Light::name),
        field("position", &Light::position, {.unit = "m", .kinds = kPlaced | kProjector, .required = true}),
        field("direction", &Light::direction,
              {.form = VectorForm::Direction,
               .help = "where the light travels",
               .kinds = only(LightKind::Spot, LightKind::Directional) | kWithImage}),
        field("color", &Light::color, {.range = kNotNegative, .form = VectorForm::Color}),
        field("intensity", &Light::strength,
              {.range = kNotNegative,
               .unit = "W/sr",
               .help =
                   "factor on color; of a spot along its axis, of a goniometric light where its picture is 1",
               .kinds = kPlaced}),
        field("irradiance", &Light::strength,
              {.range = kNotNegative,
               .unit = "W/m^2",
               .help = "on a surface that faces the light, of a projector 1 m away; a factor on color",
               .kinds = only(LightKind::Directional, LightKind::Projector),
               .alias = true}),
        field("coneAngleDeg", &Light::coneAngleDeg,
              {.range = kConeAngle,
               .unit = "degrees",
               .help = "half angle where the light ends",
               .kinds = kSpot}),
        field("coneFalloffStartDeg", &Light::coneFalloffStartDeg,
              {.range = kConeStart,
               .unit = "degrees",
               .help = "half angle where it begins to fall off; three quarters of coneAngleDeg if left out",
               .kinds = kSpot},
              {.setDefault = [](Light* light) { light->coneFalloffStartDeg = 0.75f * light->coneAngleDeg; },
               .holds = [](const Light& light) { return light.coneFalloffStartDeg <= light.coneAngleDeg; },
               .message = "\"coneFalloffStartDeg\" is {}; expected a half angle from 0 to \"coneAngleDeg\""}),
        field("up", &Light::up,
              {.form = VectorForm::Direction,
               .help = "upwards in the picture, where that is across the direction",
               .kinds = kWithImage,
               .onlyOwnKinds = true}),
        field("fovDeg", &Light::fovDeg,
              {.range = kViewAngle,
               .unit = "degrees",
               .help = "full angle across the picture's width",
               .kinds = kProjector,
               .onlyOwnKinds = true}),
        field("aspect", &Light::aspect,
              {.range = kPositive,
               .help = "width of the picture over its height",
               .kinds = kProjector,
               .onlyOwnKinds = true}),
        field("picture", &Light::image,
              {.range = kNotNegative,
               .help = "what is projected, upright as seen from the projector; of a goniometric light its "
                       "intensity by directions, in a square of equal areas with the direction in its "
                       "middle; a factor on color",
               .kinds = kWithImage,
               .onlyOwnKinds = true}),
        field("onlyRayCast", &Light::onlyRayCast,
              {.help = "shines in ray casting alone", .onlyIfSet = true})};
};

template <>
struct FieldsOf<Environment> {
    static constexpr EditKind kEdit = EditKind::Lights;
    static constexpr FieldList kList{
        field("color", &Environment::color,
              {.range = kNotNegative,
               .form = VectorForm::Color,
               .help = "radiance, or a factor on the image; 1 if left out"}),
        field("strength", &Environment::strength, {.range = kNotNegative, .help = "factor on color"}),
        field("image", &Environment::image, {.help = "latitude-longitude", .custom = true}),
        field("rotationDeg", &Environment::rotationDeg,
              {.unit = "degrees", .help = "about +y, counter-clockwise from above"}),
        field(
            "seenOnly", &Environment::seenOnly,
            {.help = "a background: rays from the camera see it, and it lights nothing", .onlyIfSet = true}),
        field("portal", &Environment::portal,
              {.unit = "m",
               .help = "four corners of the rectangle through which alone it shines and is seen, "
                       "counter-clockwise from where its light goes",
               .onlyIfSet = true},
              {.holds = [](const Environment& environment) { return isRectangle(environment.portal); },
               .message = "\"portal\" is no rectangle; expected its four corners one after the other, "
                          "counter-clockwise as seen from where the light goes",
               .isSaved = [](const Environment& environment) { return !environment.portal.empty(); }})};
};

/// What the picture depends on is the image.
template <>
struct FieldsOf<SkySource> {
    static constexpr EditKind kEdit = EditKind::Everything;
    static constexpr FieldTraits kRadiance{
        .range = kNotNegative, .form = VectorForm::Color, .inFingerprint = false};
    static constexpr FieldList kList{
        field("zenith", &SkySource::zenith, kRadiance),
        field("horizon", &SkySource::horizon, kRadiance),
        field("ground", &SkySource::ground, kRadiance),
        field("sun", &SkySource::sun, kRadiance),
        field("sunElevationDeg", &SkySource::sunElevationDeg,
              {.range = kElevation, .unit = "degrees", .inFingerprint = false}),
        field("sunAzimuthDeg", &SkySource::sunAzimuthDeg,
              {.unit = "degrees", .help = "0 is +x, 90 is -z", .inFingerprint = false}),
        field("sunRadiusDeg", &SkySource::sunRadiusDeg,
              {.range = kSunRadius,
               .unit = "degrees",
               .help = "half the angle the sun's disc subtends",
               .inFingerprint = false}),
        field("width", &SkySource::width,
              {.range = {.lo = 16, .hi = 8192}, .help = "pixels around, even", .inFingerprint = false},
              {.holds = [](const SkySource& sky) { return sky.width % 2 == 0; },
               .message = "\"width\" is odd; expected an even number of pixels"})};
};

/// Of meshes, the picture depends on those that an object places.
template <>
struct FieldsOf<SceneDescription> {
    static constexpr EditKind kEdit = EditKind::Everything;
    static constexpr FieldList kList{
        field("", &SceneDescription::path, {.inFingerprint = false}),
        label("", &SceneDescription::readWith),
        label("title", &SceneDescription::title, "what the scene shows, in one line"),
        label("description", &SceneDescription::description,
              "what to look at, or which value the picture must have"),
        field("resolution", &SceneDescription::resolution),
        field("camera", &SceneDescription::camera),
        field("render", &SceneDescription::options),
        field("", &SceneDescription::sppm),
        field("", &SceneDescription::rayCast),
        field("textures", &SceneDescription::textures),
        field("", &SceneDescription::environmentImages),
        field("materials", &SceneDescription::materials),
        field("meshes", &SceneDescription::meshes, {.inFingerprint = false}),
        field("objects", &SceneDescription::objects),
        label("", &SceneDescription::hiddenObjects),
        field("lights", &SceneDescription::lights, {.edit = EditKind::Lights}),
        field("environment", &SceneDescription::environment),
        label("", &SceneDescription::warnings),
        label("", &SceneDescription::notes),
        label("", &SceneDescription::filesRead)};
};

/// Calls visit(kind, member) for each integrator that has options of its own; `member` points to those of a
/// SceneDescription. In files their key is the integrator's.
template <class Visit>
constexpr void forEachIntegratorOptions(const Visit& visit) {
    visit(IntegratorKind::Sppm, &SceneDescription::sppm);
    visit(IntegratorKind::RayCast, &SceneDescription::rayCast);
}

/// The bit of FieldTraits::kinds that an object has.
template <class Owner>
uint32_t kindBit(const Owner& owner) {
    if constexpr (std::is_same_v<Owner, Object>) {
        return only(owner.shape);
    } else if constexpr (requires { owner.kind; }) {
        return only(owner.kind);
    } else {
        return ~0u;
    }
}

}  // namespace glint
