// How the last job of a kind ended, for the panel, the status line and the log.
#pragma once

#include <string>

#include "engine/base/result.h"

namespace glint {

class Notice {
  public:
    /// Logs it too.
    void tell(const Status& result, const std::string& success);
    /// Where a file is, for people who may not know which folder the program runs in.
    static std::string placeOf(const std::string& path);
    /// Of work that has just begun; the log is not told.
    void show(std::string text, bool isError = false);

    const std::string& text() const { return text_; }
    bool isError() const { return isError_; }

  private:
    std::string text_;
    bool isError_ = false;
};

}  // namespace glint
