// How commands declare their options, without the headers of the library that parses them: CLI11 takes ten
// seconds to compile wherever it is seen.
//
// Handles: a copy declares the same command or option. What an option points to must live as long as
// its command.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/base/result.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace glint {

class Option {
  public:
    explicit Option(CLI::Option* option) : option_(option) {}

    Option required() const;
    /// What the help calls its value: "FILE".
    Option typeName(const std::string& name) const;
    /// The help's heading that it stands under.
    Option group(const std::string& name) const;
    /// The help shows the value that the target has now.
    Option showDefault() const;

    Option range(int least, int most) const;
    Option range(uint32_t least, uint32_t most) const;
    Option range(double least, double most) const;
    Option oneOf(const std::vector<std::string>& names) const;
    /// A finite number in [least, most]; unlike range(), which lets NaN through, it does not stand in
    /// the help.
    Option between(double least, double most) const;
    /// A finite number greater than zero.
    Option aboveZero() const;
    /// A text that `check` finds nothing wrong with.
    Option accepts(std::function<Status(const std::string&)> check) const;

    /// Several values may be separated by commas; any number of them, or `least` to `most`.
    Option commaSeparated() const;
    Option commaSeparated(int least, int most) const;
    /// One value each time that the option is given.
    Option oneValueEach() const;
    Option excludes(const std::string& other) const;
    Option needs(const std::string& other) const;

  private:
    CLI::Option* option_;
};

/// Where a value goes. An optional stays empty when its option is not given.
using OptionTarget = std::variant<std::string*, int*, uint32_t*, float*, double*, std::optional<int>*,
                                  std::optional<uint32_t>*, std::optional<float>*, std::vector<std::string>*,
                                  std::vector<float>*, std::vector<double>*>;

/// An option that the user gave.
struct GivenOption {
    std::string name;   ///< "--time", or the name of an argument without dashes
    std::string group;  ///< as Option::group() had it
    bool takesValue;    ///< false: a flag
    std::string value;  ///< several are joined by commas
};

class Command {
  public:
    /// `exitCode` is set by the command that runs.
    Command(CLI::App* app, int* exitCode) : app_(app), exitCode_(exitCode) {}

    Command subcommand(const std::string& name, const std::string& about) const;
    /// Called when the user chose this command and all options are in their targets. Gives back the
    /// exit code.
    void onRun(std::function<int()> run) const;

    /// `names` as "-o,--output", or without dashes for an argument. A value without a character, such as a
    /// script's unset variable, is an error.
    Option option(const std::string& names, OptionTarget target, const std::string& help) const;
    Option flag(const std::string& names, bool* target, const std::string& help) const;
    /// Each value goes to `take`, whose error is the command line's.
    Option optionEach(const std::string& names, std::function<Status(const std::string&)> take,
                      const std::string& help) const;
    Option optionNumber(const std::string& names, std::function<void(double)> take,
                        const std::string& help) const;

    /// The text under the help.
    void footer(const std::string& text) const;
    /// One of its commands must be chosen.
    void needsSubcommand() const;
    /// Of an option that is given several times the last one counts.
    void lastCounts() const;

    /// In the order of their declaration.
    std::vector<GivenOption> given() const;

  private:
    CLI::App* app_;
    int* exitCode_;
};

}  // namespace glint
