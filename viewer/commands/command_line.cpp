// The comparisons of numbers are written so that NaN fails them.
#include "viewer/commands/command_line.h"

#include <cmath>
#include <limits>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace glint {
namespace {

template <typename Accepts>
CLI::Validator numberCheck(const std::string& expected, Accepts accepts) {
    return {[=](std::string& text) {
                double value = std::numeric_limits<double>::quiet_NaN();
                const bool isNumber = CLI::detail::lexical_cast(text, value);
                return isNumber && accepts(value) ? std::string()
                                                  : fmt::format("'{}' is not {}", text, expected);
            },
            ""};
}

Option withText(CLI::Option* option) {
    return Option(option->check(CLI::Validator(
        [](std::string& text) { return text.empty() ? "expected a value" : std::string(); }, "")));
}

}  // namespace

Option Option::required() const { return Option(option_->required()); }

Option Option::typeName(const std::string& name) const { return Option(option_->type_name(name)); }

Option Option::group(const std::string& name) const { return Option(option_->group(name)); }

Option Option::showDefault() const { return Option(option_->capture_default_str()); }

Option Option::range(int least, int most) const { return Option(option_->check(CLI::Range(least, most))); }

Option Option::range(uint32_t least, uint32_t most) const {
    return Option(option_->check(CLI::Range(least, most)));
}

Option Option::range(double least, double most) const {
    return Option(option_->check(CLI::Range(least, most)));
}

Option Option::oneOf(const std::vector<std::string>& names) const {
    return Option(option_->check(CLI::IsMember(names)));
}

Option Option::between(double least, double most) const {
    return Option(option_->check(numberCheck(fmt::format("a number from {} to {}", least, most),
                                             [=](double value) { return value >= least && value <= most; })));
}

Option Option::aboveZero() const {
    return Option(option_->check(numberCheck(
        "a number greater than 0", [](double value) { return value > 0.0 && std::isfinite(value); })));
}

Option Option::accepts(std::function<Status(const std::string&)> check) const {
    return Option(option_->check(CLI::Validator(
        [check = std::move(check)](std::string& text) {
            const Status checked = check(text);
            return checked ? std::string() : checked.error().format();
        },
        "")));
}

Option Option::commaSeparated() const { return Option(option_->delimiter(',')); }

Option Option::commaSeparated(int least, int most) const {
    return Option(option_->delimiter(',')->expected(least, most));
}

Option Option::oneValueEach() const { return Option(option_->allow_extra_args(false)); }

Option Option::excludes(const std::string& other) const { return Option(option_->excludes(other)); }

Option Option::needs(const std::string& other) const { return Option(option_->needs(other)); }

Command Command::subcommand(const std::string& name, const std::string& about) const {
    return Command(app_->add_subcommand(name, about), exitCode_);
}

void Command::onRun(std::function<int()> run) const {
    app_->callback([run = std::move(run), exitCode = exitCode_] { *exitCode = run(); });
}

Option Command::option(const std::string& names, OptionTarget target, const std::string& help) const {
    return std::visit([&](auto* value) { return withText(app_->add_option(names, *value, help)); }, target);
}

Option Command::flag(const std::string& names, bool* target, const std::string& help) const {
    return Option(app_->add_flag(names, *target, help));
}

Option Command::optionEach(const std::string& names, std::function<Status(const std::string&)> take,
                           const std::string& help) const {
    const auto takeAll = [names, take = std::move(take)](const std::vector<std::string>& values) {
        for (const std::string& value : values) {
            if (const Status taken = take(value); !taken) {
                throw CLI::ValidationError(names, taken.error().message);
            }
        }
    };
    return withText(app_->add_option_function<std::vector<std::string>>(names, takeAll, help));
}

Option Command::optionNumber(const std::string& names, std::function<void(double)> take,
                             const std::string& help) const {
    return withText(app_->add_option_function<double>(names, std::move(take), help));
}

void Command::footer(const std::string& text) const { app_->footer(text); }

void Command::needsSubcommand() const { app_->require_subcommand(1); }

void Command::lastCounts() const {
    app_->option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

std::vector<GivenOption> Command::given() const {
    std::vector<GivenOption> all;
    for (const CLI::Option* option : app_->get_options()) {
        if (option->count() > 0) {
            all.push_back({option->get_name(), option->get_group(), option->get_items_expected_max() > 0,
                           fmt::format("{}", fmt::join(option->results(), ","))});
        }
    }
    return all;
}

}  // namespace glint
