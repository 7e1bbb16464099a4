// Makes render threads give way to the UI.
#pragma once

namespace glint {

/// Lowers the calling thread's priority, and that of threads it will start (OpenMP's workers are its children
/// on Linux). Does nothing where the system does not allow it.
void lowerThreadPriority();

}  // namespace glint
