// JSON Schema draft-07: one function per group of keywords.
#include "tests/support/json_schema.h"

#include <cmath>
#include <regex>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace glint::test {
namespace {

using Json = nlohmann::json;

bool hasType(const Json& value, const std::string& type) {
    return type == "object"    ? value.is_object()
           : type == "array"   ? value.is_array()
           : type == "string"  ? value.is_string()
           : type == "boolean" ? value.is_boolean()
           : type == "number"  ? value.is_number()
           : type == "integer" ? value.is_number_integer()
                               : false;
}

std::string numberViolation(const std::string& keyword, const Json& limit, const Json& value) {
    if (!value.is_number()) { return {}; }
    const double x = value.get<double>();
    const double bound = limit.get<double>();
    const bool isFine = keyword == "minimum"            ? x >= bound
                        : keyword == "maximum"          ? x <= bound
                        : keyword == "exclusiveMinimum" ? x > bound
                        : keyword == "exclusiveMaximum" ? x < bound
                                                        : std::fmod(x, bound) == 0.0;
    return isFine ? "" : fmt::format("{} breaks {} {}", x, keyword, bound);
}

std::string sizeViolation(const std::string& keyword, const Json& limit, const Json& value) {
    const bool applies = keyword.ends_with("Items") ? value.is_array() : value.is_object();
    const bool isFine = keyword.starts_with("min") ? value.size() >= limit : value.size() <= limit;
    return !applies || isFine ? "" : fmt::format("size {} breaks {}", value.size(), keyword);
}

std::string memberViolation(const Json& root, const Json& schema, const Json& value,
                            const std::string& path) {
    if (!value.is_object()) { return {}; }
    const Json properties = schema.value("properties", Json::object());
    for (const auto& [key, member] : value.items()) {
        const std::string place = path + "/" + key;
        const Json rest = schema.value("additionalProperties", Json(true));
        if (properties.contains(key)) {
            if (auto broken = schemaViolation(root, properties[key], member, place); !broken.empty()) {
                return broken;
            }
        } else if (rest == Json(false)) {
            return place + ": is not a known key";
        } else if (rest.is_object()) {
            if (auto broken = schemaViolation(root, rest, member, place); !broken.empty()) { return broken; }
        }
    }
    for (const Json& key : schema.value("required", Json::array())) {
        if (!value.contains(key.get<std::string>())) { return path + ": lacks " + key.get<std::string>(); }
    }
    return {};
}

std::string itemViolation(const Json& root, const Json& items, const Json& value, const std::string& path) {
    for (size_t i = 0; value.is_array() && i < value.size(); ++i) {
        if (auto broken = schemaViolation(root, items, value[i], fmt::format("{}/{}", path, i));
            !broken.empty()) {
            return broken;
        }
    }
    return {};
}

/// anyOf, oneOf and allOf by the number of schemas that hold.
std::string choiceViolation(const Json& root, const std::string& keyword, const Json& schemas,
                            const Json& value, const std::string& path) {
    size_t holding = 0;
    std::string last;
    for (const Json& schema : schemas) {
        const std::string broken = schemaViolation(root, schema, value, path);
        holding += broken.empty() ? 1 : 0;
        last += broken.empty() ? "" : "\n  " + broken;
    }
    const bool isFine =
        keyword == "anyOf" ? holding > 0 : holding == (keyword == "oneOf" ? 1 : schemas.size());
    return isFine ? ""
                  : fmt::format("{}: {} of {} schemas hold ({}):{}", path, holding, schemas.size(), keyword,
                                last);
}

std::string keywordViolation(const Json& root, const Json& schema, const std::string& keyword,
                             const Json& value, const std::string& path) {
    const Json& argument = schema[keyword];
    const auto at = [&path](const std::string& broken) {
        return broken.empty() ? broken : path + ": " + broken;
    };
    if (keyword == "$schema" || keyword == "$id" || keyword == "title" || keyword == "description" ||
        keyword == "definitions") {
        return {};
    }
    if (keyword == "type") {
        return hasType(value, argument) ? "" : path + ": is not of type " + argument.get<std::string>();
    }
    if (keyword == "const" || keyword == "enum") {
        const bool isFine = keyword == "const"
                                ? value == argument
                                : std::find(argument.begin(), argument.end(), value) != argument.end();
        return isFine ? "" : fmt::format("{}: {} is not {}", path, value.dump(), argument.dump());
    }
    if (keyword == "pattern") {
        const bool isFine = !value.is_string() || std::regex_search(value.get<std::string>(),
                                                                    std::regex(argument.get<std::string>()));
        return isFine ? "" : path + ": does not match the pattern";
    }
    if (keyword == "items") { return itemViolation(root, argument, value, path); }
    if (keyword == "anyOf" || keyword == "oneOf" || keyword == "allOf") {
        return choiceViolation(root, keyword, argument, value, path);
    }
    if (keyword == "minItems" || keyword == "maxItems" || keyword == "minProperties" ||
        keyword == "maxProperties") {
        return at(sizeViolation(keyword, argument, value));
    }
    if (keyword == "minimum" || keyword == "maximum" || keyword == "exclusiveMinimum" ||
        keyword == "exclusiveMaximum" || keyword == "multipleOf") {
        return at(numberViolation(keyword, argument, value));
    }
    return fmt::format("{}: the validator does not know the keyword \"{}\"", path, keyword);
}

}  // namespace

std::string schemaViolation(const Json& root, const Json& schema, const Json& value,
                            const std::string& path) {
    if (schema.is_boolean()) { return schema.get<bool>() ? "" : path + ": nothing is allowed here"; }
    if (schema.contains("$ref")) {  // draft-07: everything beside a $ref is ignored
        const std::string pointer = schema["$ref"].get<std::string>().substr(1);
        return schemaViolation(root, root.at(Json::json_pointer(pointer)), value, path);
    }
    for (const auto& [keyword, argument] : schema.items()) {
        if (keyword == "properties" || keyword == "additionalProperties" || keyword == "required") {
            continue;
        }
        if (auto broken = keywordViolation(root, schema, keyword, value, path); !broken.empty()) {
            return broken;
        }
    }
    return memberViolation(root, schema, value, path);
}

}  // namespace glint::test
