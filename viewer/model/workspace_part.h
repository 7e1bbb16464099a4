// One part of the workspace by its type, for who knows that part alone.
#pragma once

namespace glint {

class Workspace;

/// Part: any of Workspace's parts.
template <class Part>
Part* partOf(Workspace* workspace);

}  // namespace glint
