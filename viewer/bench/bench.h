// What all of `glint bench` have in common: options, the scene that is measured on, the report.
//
// A benchmark is a file that says what it measures, and a line in bench_command.cpp.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/base/result.h"
#include "engine/builders/built_scene.h"
#include "engine/scene/scene.h"
#include "viewer/base/exit_code.h"

namespace glint {

/// What a benchmark can be asked for; each takes some of it.
struct BenchOptions {
    std::string scene = {};                ///< a file; "": the benchmark's own scene
    std::vector<std::string> scenes = {};  ///< likewise, where there may be several
    std::string mesh = {};                 ///< name of a generator (generated_mesh.h)
    std::string integrator = {};           ///< "": all of them
    std::string lookup = {};               ///< how photons are found; "": as the scene says
    int size = 0;                          ///< of the picture, pixels; 0: the scene's own
    int threads = 0;  ///< on the command line 0 stands for all; measure() gets their number
    int passes = 0;
    int turns = 0;
    int edits = 0;
    uint32_t triangles = 0;
    uint32_t photons = 0;  ///< a pass; 0: as the scene says
};

/// How one of them is written. The help shows defaults that are not 0 or "".
struct BenchOption {
    const char* name;  ///< "--passes"; "scene" stands without a name
    std::variant<int BenchOptions::*, uint32_t BenchOptions::*, std::string BenchOptions::*,
                 std::vector<std::string> BenchOptions::*>
        member;
    const char* help;
    int least = 0;
    int most = 0;  ///< as least: any number
    std::vector<std::string> choices = {};
};

/// What is measured on.
struct BenchSubject {
    const BenchOptions& options;
    /// Both null where the benchmark names no scene.
    std::shared_ptr<const SceneDescription> scene;
    std::shared_ptr<const BuiltScene> built;
};

struct BenchReport {
    std::string text;             ///< for people, with a line break at its end
    nlohmann::ordered_json json;  ///< the keys that README.md here promises
    bool isWrong = false;         ///< what was measured must not be: the exit code says so
};

struct Benchmark {
    const char* name;
    const char* about;
    BenchOptions defaults;
    std::vector<BenchOption> options;
    /// The scene that is built before measure(). Null: there is none to build.
    Result<std::shared_ptr<SceneDescription>> (*scene)(const BenchOptions& options);
    Result<BenchReport> (*measure)(const BenchSubject& subject);
    ExitCode onError = kExitFailed;  ///< of measure()
};

Benchmark accelBenchmark();
Benchmark latencyBenchmark();
Benchmark loadBenchmark();
Benchmark passesBenchmark();
Benchmark pathsBenchmark();
Benchmark raysBenchmark();
Benchmark revolveBenchmark();
Benchmark threadsBenchmark();
Benchmark variantsBenchmark();

/// --threads as most benchmarks have it.
BenchOption threadsOption(const char* help = "All by default", int least = 1);
/// --size, --passes and --turns, each within what can be measured.
BenchOption sizeOption(const char* help);
BenchOption passesOption();
BenchOption turnsOption(const char* help);
BenchOption trianglesOption();

}  // namespace glint
