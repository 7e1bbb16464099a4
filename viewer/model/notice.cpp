#include "viewer/model/notice.h"

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

void Notice::show(std::string text, bool isError) {
    text_ = std::move(text);
    isError_ = isError;
}

}  // namespace glint
