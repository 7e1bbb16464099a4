#include "engine/io/file_kind.h"

#include <algorithm>
#include <fstream>

#include "engine/io/atomic_file.h"

namespace glint {

std::string readHead(const std::string& path, size_t bytes) {
    if (!checkRegularFile(path, "a file")) { return {}; }
    std::string head(bytes, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(head.data(), static_cast<std::streamsize>(bytes));
    head.resize(static_cast<size_t>(std::max<std::streamsize>(file.gcount(), 0)));
    return head;
}

std::string_view firstText(std::string_view head) {
    if (head.starts_with("\xEF\xBB\xBF")) { head.remove_prefix(3); }
    head.remove_prefix(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
    return head;
}

}  // namespace glint
