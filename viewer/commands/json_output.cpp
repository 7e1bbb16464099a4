// nlohmann writes numbers so that they read back exactly, and infinities as null.
#include "viewer/commands/json_output.h"

#include <nlohmann/json.hpp>

#include "engine/base/console.h"
#include "engine/io/atomic_file.h"
#include "viewer/base/run_files.h"
#include "viewer/commands/command_line.h"

namespace glint {

void addJsonOption(const Command& command, std::string* target) {
    command.option("--json", target, "Write the report as JSON to FILE; - is standard output")
        .typeName("FILE")
        .accepts(checkReportFile);
}

Status checkReportFile(const std::string& target) {
    if (jsonTakesOutput(target)) { return {}; }
    const auto isReport = [](std::string_view head) { return head.starts_with("{\n  \"report\": \""); };
    const Status replaces = checkReplaces(target, isReport, "a report of Glint's");
    return replaces ? checkWritable(target) : replaces;
}

Status writeJson(const std::string& target, const std::string& command,
                 const nlohmann::ordered_json& report) {
    if (target.empty()) { return {}; }
    nlohmann::ordered_json named = {{"report", command}};
    named.update(report);
    const std::string text =
        named.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
    if (jsonTakesOutput(target)) {
        putData(text);
        return {};
    }
    return writeFileAtomically(target, text);
}

}  // namespace glint
