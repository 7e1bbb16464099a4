#include "engine/io/file_kind.h"

#include <algorithm>
#include <fstream>

#include "engine/io/plain_text.h"

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

bool looksLikeText(std::string_view head) {
    constexpr auto isControl = [](char c) {
        return static_cast<unsigned char>(c) < ' ' &&
               std::string_view("\t\n\v\f\r\x1a\x1b").find(c) == std::string_view::npos;
    };
    constexpr size_t kBytesPerControl = 64;  // random bytes have one in 10
    return static_cast<size_t>(std::ranges::count_if(head, isControl)) <= head.size() / kBytesPerControl ||
           isUtf16(head);
}

Result<std::string> readFileOfKind(const std::string& path,
                                   const std::function<bool(std::string_view head)>& isOfKind,
                                   uint64_t most) {
    std::string head = readHead(path);
    const bool isOther = head.size() == kHeadBytes && !isOfKind(head);
    return isOther ? Result<std::string>(std::move(head)) : readFile(path, most);
}

}  // namespace glint
