// What a panel is made of. A new one is a file that defines its Panel and a line in panels.cpp.
#pragma once

#include <type_traits>

#include "viewer/model/workspace_part.h"

namespace glint {

enum class WithoutScene { Draws, Hints, Hides };

struct Panel {
    const char* title;
    bool isOpenAtFirst;
    void (*draw)(Workspace* workspace);  ///< one section's rows
    WithoutScene withoutScene = WithoutScene::Draws;
    const char* tooltip = nullptr;
    /// Asked while a scene is open. Null: always.
    bool (*isShown)(Workspace* workspace) = nullptr;
};

/// Makes a function of some parts one of the workspace.
template <auto function>
struct OfParts;
template <class Answer, class... Parts, Answer (*function)(Parts*...)>
struct OfParts<function> {
    static Answer call([[maybe_unused]] Workspace* workspace) {
        return function(partOf<std::remove_const_t<Parts>>(workspace)...);
    }
};

}  // namespace glint
