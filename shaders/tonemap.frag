#version 330 core
// Linear radiance to display values. Mirrors engine/render/tonemap.cpp line by line; the two agree to 1/255, and
// tests/viewer compares them. Change both or neither.

uniform sampler2D radiance;   // linear Rec.709; row 0 is the picture's top row
uniform float exposureStops;
uniform int toneMap;          // same order as ToneMap

out vec4 displayColor;

const float kMaxToneInput = 1e6;
const float kReinhardWhite = 4.0;

float filmicCurve(float x) {
    float v = 0.6 * x;
    return clamp((v * (2.51 * v + 0.03)) / (v * (2.43 * v + 0.59) + 0.14), 0.0, 1.0);
}

vec3 reinhard(vec3 rgb) {
    float l = dot(rgb, vec3(0.2126, 0.7152, 0.0722));
    return rgb * ((1.0 + l / (kReinhardWhite * kReinhardWhite)) / (1.0 + l));
}

float linearToSrgb(float linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1.0 / 2.4) - 0.055;
}

vec3 encoded(vec3 rgb) {
    rgb = clamp(rgb, 0.0, 1.0);
    return vec3(linearToSrgb(rgb.r), linearToSrgb(rgb.g), linearToSrgb(rgb.b));
}

// The comparison is false for NaN, which so becomes 0.
float toneInput(float value) {
    float exposed = value * exp2(exposureStops);
    return exposed > 0.0 ? min(exposed, kMaxToneInput) : 0.0;
}

void main() {
    vec3 value = texelFetch(radiance, ivec2(gl_FragCoord.xy), 0).rgb;
    vec3 rgb = vec3(toneInput(value.r), toneInput(value.g), toneInput(value.b));
    if (toneMap == 0) {
        rgb = clamp(rgb, 0.0, 1.0);
    } else if (toneMap == 1) {
        rgb = encoded(rgb);
    } else if (toneMap == 2) {
        rgb = encoded(vec3(filmicCurve(rgb.r), filmicCurve(rgb.g), filmicCurve(rgb.b)));
    } else {
        rgb = encoded(reinhard(rgb));
    }
    displayColor = vec4(rgb, 1.0);
}
