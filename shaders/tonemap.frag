#version 330 core
// Linear radiance to display values. Mirrors engine/render/tonemap.cpp line by line; the two agree to 1/255, and
// tests/viewer compares them. Change both or neither.

uniform sampler2D radiance;   // linear Rec.709; row 0 is the picture's top row
uniform float exposureStops;
uniform int toneMap;          // same order as ToneMap
uniform bool isNeutral;       // white stays what it is
uniform mat3 balance;         // whiteBalanceMatrix()
uniform bool dithers;

out vec4 displayColor;

const float kMaxToneInput = 1e6;
const float kReinhardWhite = 4.0;
const float kSoftContrast = 1.2;
const float kSoftMixedIn = 0.2;
const float kSoftTakenOut = 0.1;
const float kSoftShoulder = 0.58193;

float filmicCurve(float x) {
    float v = 0.6 * x;
    return clamp((v * (2.51 * v + 0.03)) / (v * (2.43 * v + 0.59) + 0.14), 0.0, 1.0);
}

vec3 reinhard(vec3 rgb) {
    float l = dot(rgb, vec3(0.2126, 0.7152, 0.0722));
    return rgb * ((1.0 + l / (kReinhardWhite * kReinhardWhite)) / (1.0 + l));
}

float softCurve(float x) {
    float raised = pow(max(x, 0.0), kSoftContrast);
    return raised / (raised + kSoftShoulder);
}

vec3 softHighlights(vec3 rgb) {
    vec3 weights = vec3(0.2126, 0.7152, 0.0722);
    vec3 mixed = rgb + kSoftMixedIn * (vec3(dot(rgb, weights)) - rgb);
    float high = max(mixed.r, max(mixed.g, mixed.b));
    float low = min(mixed.r, min(mixed.g, mixed.b));
    float lowest = softCurve(low);
    float slope = high > low ? (softCurve(high) - lowest) / (high - low) : 0.0;
    vec3 curved = vec3(lowest) + (mixed - vec3(low)) * slope;
    return (curved - kSoftTakenOut * dot(curved, weights)) / (1.0 - kSoftTakenOut);
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

// ditherOffset() / 255: the framebuffer rounds.
float ditherOffset(ivec2 pixel, int channel) {
    float along = 0.06711056 * float(pixel.x + 23 * channel) + 0.00583715 * float(pixel.y + 47 * channel);
    float scaled = 52.9829189 * (along - floor(along));
    return (scaled - floor(scaled) - 0.5) / 255.0;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 value = texelFetch(radiance, pixel, 0).rgb;
    if (!isNeutral) { value = balance * value; }
    vec3 rgb = vec3(toneInput(value.r), toneInput(value.g), toneInput(value.b));
    if (toneMap == 0) {
        rgb = clamp(rgb, 0.0, 1.0);
    } else if (toneMap == 1) {
        rgb = encoded(rgb);
    } else if (toneMap == 2) {
        rgb = encoded(vec3(filmicCurve(rgb.r), filmicCurve(rgb.g), filmicCurve(rgb.b)));
    } else if (toneMap == 3) {
        rgb = encoded(reinhard(rgb));
    } else {
        rgb = encoded(softHighlights(rgb));
    }
    if (dithers) {
        rgb = clamp(rgb, 0.0, 1.0);
        vec3 offset = vec3(ditherOffset(pixel, 0), ditherOffset(pixel, 1), ditherOffset(pixel, 2));
        rgb += offset * vec3(greaterThan(rgb, vec3(0.0)));
    }
    displayColor = vec4(rgb, 1.0);
}
