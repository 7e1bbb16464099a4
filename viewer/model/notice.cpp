#include "viewer/model/notice.h"

#include <filesystem>
#include <utility>

#include "engine/base/log.h"

namespace glint {

void Notice::tell(const Status& result, const std::string& success) {
    show(result.ok() ? success : result.error().format(), !result.ok());
    if (result.ok()) {
        logInfo("{}", text_);
    } else {
        logError("{}", text_);
    }
}

std::string Notice::placeOf(const std::string& path) {
    std::error_code problem;
    const std::filesystem::path absolute = std::filesystem::absolute(path, problem);
    return problem ? path : absolute.lexically_normal().string();
}

void Notice::show(std::string text, bool isError) {
    text_ = std::move(text);
    isError_ = isError;
}

}  // namespace glint
