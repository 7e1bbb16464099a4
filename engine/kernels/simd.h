// Which vector instructions kernel code may use: GLINT_HAS_AVX2 and GLINT_HAS_AVX512, 0 or 1.
//
// Device code never has them. Every vector body stands beside a scalar one that gives the same bits.
#pragma once

#include "engine/base/host_device.h"

#if !GLINT_ON_DEVICE && defined(__AVX2__) && defined(__FMA__)
#include <immintrin.h>
#define GLINT_HAS_AVX2 1
#else
#define GLINT_HAS_AVX2 0
#endif

#if GLINT_HAS_AVX2 && defined(__AVX512F__) && defined(__AVX512VL__) && defined(__AVX512DQ__)
#define GLINT_HAS_AVX512 1
#else
#define GLINT_HAS_AVX512 0
#endif
