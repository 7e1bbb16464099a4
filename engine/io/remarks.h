// What a reader repaired, left out or guessed: each kind once, with its number and where it came first, so
// that what is said of a file of a million odd lines is bounded.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

class Remarks {
  public:
    /// `kind` is a sentence that lives as long as the program, and is known by its address. Of the first of a
    /// kind alone, `place()` is asked for where it is, and `detail` (and `more()`) for what is shown behind.
    template <class Place, class More = std::string (*)()>
    void add(
        std::string_view kind, const Place& place, std::string_view detail = {},
        const More& more = [] { return std::string(); }) {
        for (Entry& entry : entries_) {
            if (entry.kind.data() == kind.data()) {
                ++entry.count;
                return;
            }
        }
        entries_.push_back({kind, place(), std::string(detail.substr(0, kShownDetail)), more(), 1});
    }

    /// Those of another reader, counted with these.
    void add(const Remarks& more);

    /// `place: sentence: "detail" (and 3 more)`, in the order of the first ones.
    std::vector<std::string> lines() const;

  private:
    static constexpr size_t kShownDetail = 80;
    struct Entry {
        std::string_view kind;
        std::string place;
        std::string detail;
        std::string more;
        uint64_t count;
    };
    std::vector<Entry> entries_;
};

/// Leaves the first lines, and one that says how many more there were, where there are very many: one of each
/// kind may still be one of each file.
void boundLines(std::vector<std::string>* lines);

}  // namespace glint
