// `glint bench`: one subcommand per figure. A new benchmark adds its line here.
#include <CLI/CLI.hpp>

#include "viewer/commands/commands.h"

namespace glint {

void addBenchCommand(CLI::App& app, int* exitCode) {
    CLI::App* bench = app.add_subcommand(
        "bench", "Measures speed: rays, paths, photon passes, latency, loading, threads, kernels");
    bench->require_subcommand(1);
    bench->footer("Figures are only worth something on a machine that does nothing else.");
    addBenchRays(*bench, exitCode);
    addBenchPaths(*bench, exitCode);
    addBenchPasses(*bench, exitCode);
    addBenchLatency(*bench, exitCode);
    addBenchLoad(*bench, exitCode);
    addBenchThreads(*bench, exitCode);
    addBenchVariants(*bench, exitCode);
}

}  // namespace glint
