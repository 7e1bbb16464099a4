// Commands are added one line each; what is wrong with an option is said once, with the nearest known option.
#include "viewer/commands/program.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string_view>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include "engine/base/console.h"
#include "engine/base/log.h"
#include "engine/base/nearest_name.h"
#include "viewer/base/interrupt.h"
#include "viewer/commands/command_line.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/measuring_program.h"

namespace glint {
namespace {

constexpr const char* kProgramFooter =
    R"(A SCENE is Glint JSON, a 6.837-style text scene, OBJ (with its MTL), PLY, STL, glTF 2.0, Mitsuba XML or pbrt-v4.
Without a command, `glint [SCENE]` opens the window, as `glint view` does.

Exit codes: 0 done, 1 the input or the options are wrong, 2 the run failed, 3 a limit that was asked for is exceeded,
130 interrupted after saving.
`glint COMMAND --help` explains a command.)";

/// Long and short names of the options of `app`, with their dashes.
std::vector<std::string> optionNames(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    return names;
}

std::vector<std::string> commandNames(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) {
        names.push_back(command->get_name());
    }
    return names;
}

std::string nearest(const std::string& unknown, const std::vector<std::string>& known) {
    const std::vector<std::string_view> views(known.begin(), known.end());
    return didYouMean(unknown, views);
}

/// The innermost command that was chosen, and its full name.
const CLI::App* chosenCommand(const CLI::App& app, std::string* name) {
    const CLI::App* chosen = &app;
    *name = app.get_name();
    while (!chosen->get_subcommands().empty()) {
        chosen = chosen->get_subcommands().front();
        *name += " " + chosen->get_name();
    }
    return chosen;
}

void printUnknown(const CLI::App& app, const CLI::App& chosen, const std::string& name) {
    const std::vector<std::string> extras = app.remaining(true);
    const std::string word = extras.empty() ? "" : extras.front();
    const bool option = word.starts_with("-");
    const std::string bare = word.substr(0, word.find('='));
    const std::vector<std::string> known = option ? optionNames(chosen) : commandNames(chosen);
    const char* what = option ? "option" : known.empty() ? "argument" : "command";
    say("{}: unknown {} '{}'{}; see `{} --help`\n", name, what, bare, nearest(bare, known), name);
}

int answerParseError(const CLI::App& app, const CLI::ParseError& problem) {
    if (problem.get_exit_code() == 0) {
        return app.exit(problem) == 0 ? kExitDone : kExitBadInput;  // --help, --version
    }
    std::string name;
    const CLI::App* chosen = chosenCommand(app, &name);
    // A misspelt word often also makes something required missing; the word is what to name.
    if (!app.remaining(true).empty()) {
        printUnknown(app, *chosen, name);
    } else {
        say("{}: {}; see `{} --help`\n", name, problem.what(), name);
    }
    return kExitBadInput;
}

/// True for a first word that is neither a command nor an option: a scene to view.
bool namesAScene(const CLI::App& app, const std::string& word) {
    const std::vector<std::string> commands = commandNames(app);
    const bool looksLikeAFile = word.find('.') != std::string::npos || word.find('/') != std::string::npos;
    return !word.starts_with("-") && looksLikeAFile && std::ranges::find(commands, word) == commands.end();
}

void addViewWhereItIsMeant(const CLI::App& app, std::vector<std::string>* arguments) {
    const std::vector<std::string> commands = commandNames(app);
    const bool canView = std::ranges::find(commands, "view") != commands.end();
    if (canView && (arguments->empty() || namesAScene(app, arguments->front()))) {
        arguments->insert(arguments->begin(), "view");
    }
}

/// Text that went to a full disk or a closed pipe is a result that nobody got.
int flushOutput(int exitCode) {
    const int problem = finishOutput();
    if (problem == 0) { return exitCode; }
    say("error: standard output cannot be written: {}\n", std::strerror(problem));
    return exitCode == kExitDone ? kExitFailed : exitCode;
}

int parseAndRun(std::vector<std::string> arguments, void (*addCommands)(const Command& program)) {
    int exitCode = kExitDone;
    CLI::App app("Glint: a path tracer that shows a scene converging.", "glint");
    app.set_version_flag("--version", std::string("glint ") + GLINT_VERSION);
    app.require_subcommand(1);
    app.fallthrough();
    app.add_flag_callback(
           "--quiet", [] { setLogLevel(LogLevel::Error); }, "Log errors only")
        ->trigger_on_parse();
    app.add_flag_callback(
           "--verbose", [] { setLogLevel(LogLevel::Debug); }, "Log everything")
        ->trigger_on_parse();
    addCommands(Command(&app, &exitCode));
    addViewWhereItIsMeant(app, &arguments);
    std::ranges::reverse(arguments);  // CLI11 takes them from the back.
    try {
        app.parse(std::move(arguments));
    } catch (const CLI::ParseError& problem) { return answerParseError(app, problem); }
    return exitCode;
}

/// Libraries allocate in functions that may not throw. Where memory runs short in them, this says so.
[[noreturn]] void endWithReason() {
    try {
        if (std::current_exception()) { std::rethrow_exception(std::current_exception()); }
    } catch (const std::bad_alloc&) {
        constexpr std::string_view kReason = "error: not enough memory\n";
        [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, kReason.data(), kReason.size());
        std::_Exit(kExitFailed);
    } catch (...) {}
    __gnu_cxx::__verbose_terminate_handler();
    std::abort();
}

}  // namespace

void addProgramCommands(const Command& program) {
    program.footer(kProgramFooter);
    addViewCommand(program);
    addRenderCommand(program);
    addInfoCommand(program);
    addConvergeCommand(program);
    addConvertCommand(program);
    addSchemaCommand(program);
    addExampleCommand(program);
    addDiffCommand(program);
    addBesideCommand(program);
    for (const MeasuringCommand& command : kMeasuringCommands) {
        program.subcommand(command.name, command.about);
    }
}

int runProgram(std::vector<std::string> arguments, void (*addCommands)(const Command& program)) {
    prepareStandardStreams();
    takeSignals();
    std::set_terminate(endWithReason);
    try {
        return flushOutput(parseAndRun(std::move(arguments), addCommands));
    } catch (const std::bad_alloc&) {
        say("error: not enough memory\n");
        return kExitFailed;
    } catch (const std::system_error& problem) {
        const bool isThread = problem.code() == std::errc::resource_unavailable_try_again;
        say("error: {}\n", isThread ? "no thread starts; memory or their number is limited" : problem.what());
        return kExitFailed;
    } catch (const std::exception& problem) {
        say("glint: {}\n", problem.what());
        return kExitFailed;
    }
}

}  // namespace glint
