// pugixml parses without recursion and expands no entities but XML's own five.
#include "engine/io/mitsuba_xml.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "engine/io/file_kind.h"
#include "engine/io/file_path.h"
#include "engine/io/plain_text.h"

namespace glint {

struct MitsubaXml::File {
    std::string path;
    std::string text;
    pugi::xml_document tree;
};

namespace {

constexpr int kMaxLevels = 100;
constexpr size_t kMaxElements = 4'000'000;
constexpr size_t kMaxReplacedBytes = size_t{256} << 20;

bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }
bool isNameCharacter(char c) {
    return isUpper(c) || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
}

/// "toWorld" as "to_world", "intIOR" as "int_ior".
std::string underscored(std::string_view name) {
    std::string out;
    for (size_t i = 0; i < name.size(); ++i) {
        if (isUpper(name[i]) && i > 0 && !isUpper(name[i - 1]) && name[i - 1] != '_') { out += '_'; }
        out += isUpper(name[i]) ? static_cast<char>(name[i] - 'A' + 'a') : name[i];
    }
    return out;
}

std::string_view usualTag(std::string_view tag) {
    return tag == "lookAt" ? "lookat" : tag == "luminaire" ? "emitter" : tag == "camera" ? "sensor" : tag;
}

}  // namespace

/// Makes elements of files, in their order, since parameters hold from where they are set.
class MitsubaXmlReader {
  public:
    MitsubaXmlReader(MitsubaXml* xml, const SceneParameters& given) : xml_(*xml) {
        for (const auto& [name, value] : given) {
            xml_.parameters_[name] = {value, true, false};
        }
    }

    Status read(const std::string& path) {
        including_.push_back(std::filesystem::path(path).lexically_normal().string());
        const auto file = open(path);
        if (!file) { return file.error(); }
        const pugi::xml_node root = xml_.files_[*file]->tree.document_element();
        if (std::string_view(root.name()) != "scene") {
            return errorAt(*file, root, "expected <scene> as the outermost element");
        }
        const std::string_view version = root.attribute("version").value();
        if (!version.empty()) { xml_.majorVersion_ = version[0] == '0' ? 0 : version[0] - '0'; }
        xml_.root_ = {"scene", {}, {}, *file, offsetOf(root)};
        return expand(*file, root, 1, &xml_.root_);
    }

  private:
    static size_t offsetOf(const pugi::xml_node& node) {
        const ptrdiff_t offset = node.offset_debug();
        return offset > 0 ? static_cast<size_t>(offset) - 1 : 0;
    }

    Error errorAt(uint32_t file, const pugi::xml_node& node, std::string message) const {
        return {std::move(message), xml_.placeIn(*xml_.files_[file], offsetOf(node))};
    }

    Result<uint32_t> open(const std::string& path) {
        const auto number = static_cast<uint32_t>(xml_.files_.size());
        const auto [known, isNew] =
            opened_.try_emplace(std::filesystem::path(path).lexically_normal().string(), number);
        if (!isNew) { return known->second; }
        Result<std::string> bytes = readFileOfKind(path, looksLikeText);
        if (!bytes) { return bytes.error(); }
        xml_.files_.push_back(std::make_unique<MitsubaXml::File>());
        MitsubaXml::File& file = *xml_.files_.back();
        file.path = path;
        std::optional<PlainText> plain = asPlainText(*bytes);
        file.text = plain ? std::move(plain->text) : std::move(*bytes);
        if (file.text.starts_with("\xEF\xBB\xBF")) { file.text.erase(0, 3); }
        const auto parsed =
            file.tree.load_buffer(file.text.data(), file.text.size(),
                                  pugi::parse_default | pugi::parse_doctype, pugi::encoding_utf8);
        if (!parsed) {
            const auto offset =
                std::min(static_cast<size_t>(std::max<ptrdiff_t>(parsed.offset, 0)), file.text.size());
            return Error{fmt::format("is no XML that can be read: {}", parsed.description()),
                         xml_.placeIn(file, offset)};
        }
        for (const pugi::xml_node& node : file.tree.children()) {
            if (std::string_view(node.value()).find("<!ENTITY") != std::string_view::npos) {
                return errorAt(number, node, "declares entities, which Glint does not expand");
            }
        }
        return number;
    }

    Status expand(uint32_t file, const pugi::xml_node& parent, int level, MitsubaElement* out) {
        if (level > kMaxLevels) {
            return errorAt(file, parent, fmt::format("is nested deeper than {} levels", kMaxLevels));
        }
        for (const pugi::xml_node& node : parent.children()) {
            if (node.type() != pugi::node_element) { continue; }
            if (++elements_ > kMaxElements) {
                return errorAt(
                    file, node,
                    fmt::format("the scene has more than {} elements with what it includes", kMaxElements));
            }
            MitsubaElement element{usualTag(node.name()), {}, {}, file, offsetOf(node)};
            if (Status read = readAttributes(file, node, &element); !read) { return read; }
            Status done;
            if (element.tag == "default") {
                setParameter(element);
            } else if (element.tag == "path") {
                xml_.folders_.insert(
                    xml_.folders_.begin(),
                    resolvePath(std::string(element.attribute("value")), xml_.files_[file]->path));
            } else if (element.tag == "include") {
                done = include(element, level, out);
            } else {
                done = expand(file, node, level + 1, &element);
                out->children.push_back(std::move(element));
            }
            if (!done) { return done; }
        }
        return {};
    }

    /// The first default counts.
    void setParameter(const MitsubaElement& element) {
        const std::string value(element.attribute("value"));
        const auto [parameter, isNew] = xml_.parameters_.try_emplace(std::string(element.attribute("name")),
                                                                     MitsubaXml::Parameter{value});
        parameter->second.isUsed = true;
    }

    Status include(const MitsubaElement& element, int level, MitsubaElement* out) {
        const std::string path = xml_.findFile(element, element.attribute("filename"));
        const std::string key = std::filesystem::path(path).lexically_normal().string();
        if (std::ranges::find(including_, key) != including_.end()) {
            return xml_.error(element, fmt::format("\"{}\" includes itself", path));
        }
        const auto file = open(path);
        if (!file) {
            return file.error().place.line > 0 ? file.error()
                                               : xml_.error(element, fmt::format("cannot include \"{}\": {}",
                                                                                 path, file.error().message));
        }
        including_.push_back(key);
        const pugi::xml_node tree = xml_.files_[*file]->tree;
        const pugi::xml_node root = xml_.files_[*file]->tree.document_element();
        const bool isScene = std::string_view(root.name()) == "scene";
        Status done = expand(*file, isScene ? root : tree, level + 1, out);
        including_.pop_back();
        return done;
    }

    Status readAttributes(uint32_t file, const pugi::xml_node& node, MitsubaElement* element) {
        for (const pugi::xml_attribute& attribute : node.attributes()) {
            std::string_view value = attribute.value();
            const std::string_view name = attribute.name();
            if (value.find('$') != std::string_view::npos) {
                if (Status done = replaceParameters(file, node, &value); !done) { return done; }
            }
            if (name == "name" && element->tag != "default" && std::ranges::any_of(value, isUpper)) {
                value = keep(underscored(value));
            }
            element->attributes.push_back({name, value});
        }
        return {};
    }

    std::string_view keep(std::string text) { return xml_.replaced_.emplace_back(std::move(text)); }

    /// The longest known name behind a `$` counts.
    Status replaceParameters(uint32_t file, const pugi::xml_node& node, std::string_view* value) {
        std::string out;
        for (size_t i = 0; i < value->size(); ++i) {
            if (value->substr(i).starts_with("\\$")) {
                out += '$';
                ++i;
                continue;
            }
            if ((*value)[i] != '$') {
                out += (*value)[i];
                continue;
            }
            size_t end = i + 1;
            while (end < value->size() && isNameCharacter((*value)[end])) {
                ++end;
            }
            const std::string_view name = value->substr(i + 1, end - i - 1);
            auto found = xml_.parameters_.end();
            for (size_t length = name.size(); length > 0 && found == xml_.parameters_.end(); --length) {
                found = xml_.parameters_.find(name.substr(0, length));
            }
            if (found == xml_.parameters_.end()) {
                return errorAt(
                    file, node,
                    fmt::format("the parameter \"${}\" has no value; expected <default> before it, "
                                "or -D {}=VALUE",
                                name, name));
            }
            found->second.isUsed = true;
            out += found->second.value;
            i += found->first.size();
            if (replacedBytes_ + out.size() > kMaxReplacedBytes) {
                return errorAt(file, node, "parameters make texts of more than 256 MiB");
            }
        }
        replacedBytes_ += out.size();
        *value = keep(std::move(out));
        return {};
    }

    MitsubaXml& xml_;
    std::map<std::string, uint32_t> opened_;  ///< each file once, however often it is included
    std::vector<std::string> including_;
    size_t elements_ = 0;
    size_t replacedBytes_ = 0;
};

MitsubaXml::~MitsubaXml() = default;

Result<std::unique_ptr<MitsubaXml>> MitsubaXml::read(const std::string& path,
                                                     const SceneParameters& parameters) {
    std::unique_ptr<MitsubaXml> xml(new MitsubaXml());
    if (Status read = MitsubaXmlReader(xml.get(), parameters).read(path); !read) { return read.error(); }
    xml->collectIds(xml->root_);
    return xml;
}

void MitsubaXml::collectIds(const MitsubaElement& element) {
    for (const MitsubaElement& child : element.children) {
        if (child.tag == "alias") {
            if (const MitsubaElement* named = find(child.attribute("id"))) {
                ids_.emplace(child.attribute("as"), named);
            }
        } else if (child.tag != "ref" && child.has("id")) {
            ids_.emplace(child.attribute("id"), &child);
        }
        collectIds(child);
    }
}

const MitsubaElement* MitsubaXml::find(std::string_view id) const {
    const auto found = ids_.find(id);
    return found != ids_.end() ? found->second : nullptr;
}

std::vector<std::string> MitsubaXml::unusedParameters() const {
    std::vector<std::string> names;
    for (const auto& [name, parameter] : parameters_) {
        if (parameter.isGiven && !parameter.isUsed) { names.push_back(name); }
    }
    return names;
}

SourcePlace MitsubaXml::placeIn(const File& file, size_t offset) const {
    const std::string_view before = std::string_view(file.text).substr(0, offset);
    const size_t begin = before.rfind('\n') + 1;  // npos + 1 is 0
    const size_t end = std::min(file.text.find('\n', offset), file.text.size());
    return {file.path, 1 + static_cast<int>(std::ranges::count(before, '\n')),
            static_cast<int>(before.size() - begin) + 1, file.text.substr(begin, end - begin)};
}

Error MitsubaXml::error(const MitsubaElement& at, std::string message) const {
    return {std::move(message), placeIn(*files_[at.file], at.offset)};
}

std::string MitsubaXml::placeOf(const MitsubaElement& at) const {
    const SourcePlace place = placeIn(*files_[at.file], at.offset);
    return fmt::format("{}:{}", place.file, place.line);
}

std::string MitsubaXml::findFile(const MitsubaElement& at, std::string_view name) const {
    std::string file(name);
    std::ranges::replace(file, '\\', '/');
    for (const std::string& folder : folders_) {
        std::string path = (std::filesystem::path(folder) / file).string();
        if (fileExists(path)) { return path; }
    }
    return findBeside(name, files_[0]->path, files_[at.file]->path);
}

}  // namespace glint
