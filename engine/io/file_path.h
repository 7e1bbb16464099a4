// Paths in scene files, and endings of names. Nothing here opens a file.
#pragma once

#include <string>
#include <string_view>

namespace glint {

/// `path` as seen from the folder of the file `from`; absolute paths stay.
std::string resolvePath(const std::string& path, const std::string& from);

/// `path`, which is relative to the folder of `from`, made relative to the folder of `to`. Absolute paths
/// stay, and so does a path that has no relative form.
std::string rebasePath(const std::string& path, const std::string& from, const std::string& to);

/// `found`, which the scene file `scenePath` calls `name`, as seen from that file's folder; names that are
/// absolute stay.
std::string seenFromFolder(const std::string& found, std::string_view name, const std::string& scenePath);

/// The file that is called `name`, with slashes of either kind: beside `scenePath`, or else beside `ownPath`,
/// the file that names it; beside `scenePath` where it is nowhere.
std::string findBeside(std::string_view name, const std::string& scenePath, const std::string& ownPath);

/// True when the resolved path names an existing file that is not a folder.
bool fileExists(const std::string& resolvedPath);

/// Where a chain of symbolic links leads, also to a file that is not there yet. Other paths stay as they are.
std::string followLinks(const std::string& path);

/// ".png" of "a/b.PNG": in lower case (ASCII), with the dot; empty where there is none.
std::string extensionOf(const std::string& path);

/// Whether the path ends in one of `extensions`, which are in lower case, with their dots, a blank apart.
bool hasExtension(const std::string& path, std::string_view extensions);

}  // namespace glint
