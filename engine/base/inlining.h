// What the host's compiler is told about inlining, where its own guess costs much time: a path tracer has
// dozens of small functions that hand vectors to each other through memory unless they become one.
//
// For kernels on the CPU. CUDA's compiler inlines all it can by itself, and builds for debugging and with
// sanitizers are better built soon.
#pragma once

#include "engine/base/host_device.h"

#if GLINT_ON_DEVICE || !defined(__OPTIMIZE__) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define GLINT_FLATTEN
#define GLINT_ONE_PIECE
#else
/// Everything that the function calls is inlined into it, and what that calls, too, up to a GLINT_ONE_PIECE.
#define GLINT_FLATTEN __attribute__((flatten))
/// The same, and the function itself is inlined nowhere: one copy for all callers.
#define GLINT_ONE_PIECE __attribute__((flatten, noinline))
#endif

/// One piece on the host; on a device a function that is called: it is too large to be copied to every place.
#if GLINT_ON_DEVICE
#define GLINT_ONE_PIECE_APART __noinline__
#else
#define GLINT_ONE_PIECE_APART GLINT_ONE_PIECE
#endif
