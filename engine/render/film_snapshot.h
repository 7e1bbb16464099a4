// A picture at one moment, as displays and files read it. Immutable and shared.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "engine/render/film.h"
#include "engine/render/integrator_map.h"
#include "engine/scene/integrator_kind.h"

namespace glint {

/// Counts the edits and restarts that were posted to a session, from 1. 0: none yet.
using EditTicket = uint64_t;

/// Tells films of one scene apart: each restart that can be gone back behind begins another take.
using FilmTake = uint64_t;

struct FilmSnapshot {
    EditTicket ticket = 0;  ///< of the newest edit that it answers
    int width = 0;          ///< smaller than the film's while something moves
    int height = 0;
    int previewScale = 1;       ///< film pixels per snapshot pixel in each direction; 1: full resolution
    bool isFirstFrame = false;  ///< of a scene that is being built (first_frame.h), not by the integrator
    bool isDenoised = false;    ///< `radiance` and `standardError` are denoised_snapshot.h's
    IntegratorKind integrator = IntegratorKind::PathTracing;
    uint32_t passes = 0;
    double renderSeconds = 0.0;     ///< time spent in passes since the last restart, resumed time included
    double relativeError = 0.0;     ///< of the whole picture, noise and bias (error_estimate.h)
    double relativeErrorLow = 0.0;  ///< 90 % band of relativeError
    double relativeErrorHigh = 0.0;
    std::vector<float> radiance;       ///< linear RGB, 3 per pixel
    std::vector<float> standardError;  ///< of the mean luminance, 1 per pixel; empty unless asked for
    /// Estimate of the luminance's bias, signed. Empty unless asked for, and where the integrator has none.
    std::vector<float> bias;
    /// With 90 %, the true luminance is within +- this. Empty unless asked for.
    std::vector<float> errorBound;
    std::vector<IntegratorMap> maps;  ///< the integrator's own; empty unless asked for
    /// Of the snapshot's size; null unless asked for, and until the first is made.
    std::shared_ptr<const AovFilm> aovs;

    /// Empty when the snapshot carries no map of that name.
    const std::vector<float>& map(std::string_view name) const {
        static const std::vector<float> kNoValues;
        for (const IntegratorMap& each : maps) {
            if (each.name == name) { return each.values; }
        }
        return kNoValues;
    }
};

}  // namespace glint
