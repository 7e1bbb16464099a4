// nlohmann writes numbers so that they read back exactly, and infinities as null.
#include "viewer/commands/json_output.h"

#include <nlohmann/json.hpp>

#include "engine/base/console.h"
#include "engine/io/atomic_file.h"
#include "viewer/commands/command_line.h"

namespace glint {

void addJsonOption(const Command& command, std::string* target) {
    command.option("--json", target, "Write the report as JSON to FILE; - is standard output")
        .typeName("FILE")
        .writableFile();
}

Status writeJson(const std::string& target, const nlohmann::ordered_json& report) {
    if (target.empty()) { return {}; }
    const std::string text =
        report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
    if (jsonTakesOutput(target)) {
        putData(text);
        return {};
    }
    return writeFileAtomically(target, text);
}

}  // namespace glint
