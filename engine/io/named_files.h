// Files that a model names, found as other programs and systems write their names. For the readers of OBJ,
// MTL and PLY.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

/// What stands before a blank and a #, without blanks at its end.
std::string_view withoutComment(std::string_view name);

class NamedFiles {
  public:
    struct Found {
        std::string path;
        bool isGuess = false;  ///< not where the name says
    };

    /// The file that `name`, in the file `from`, means: the first that is there of the name as it stands;
    /// with slashes for backslashes; without quotes, escapes, %20 and what follows a #; in other case; and at
    /// last its mere file name beside `from`.
    std::optional<Found> find(const std::string& name, const std::string& from);

  private:
    /// The file in `folder` whose name is `name` but for upper and lower case; empty: none.
    std::string inOtherCase(const std::string& folder, const std::string& name);

    std::map<std::string, std::map<std::string, std::string>>
        listings_;  ///< by folder and name in small letters
};

}  // namespace glint
