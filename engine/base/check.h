// CHECK: for what only we can get wrong. It prints the operands and aborts, in every build type.
//
// Never use it for anything a file, an option or an edit can cause: those are Errors (result.h). Host
// code only.
#pragma once

#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>

namespace glint::detail {

[[noreturn]] inline void checkFailed(const char* file, int line, const char* what,
                                     const std::string& operands) {
    fmt::print(stderr, "{}:{}: internal check failed: {} {}\n", file, line, what, operands);
    std::abort();
}

}  // namespace glint::detail

#define GLINT_CHECK(condition)                                                                  \
    do {                                                                                        \
        if (!(condition)) { ::glint::detail::checkFailed(__FILE__, __LINE__, #condition, ""); } \
    } while (false)

#define GLINT_CHECK_OP(a, op, b)                                                \
    do {                                                                        \
        if (!((a)op(b))) {                                                      \
            ::glint::detail::checkFailed(__FILE__, __LINE__, #a " " #op " " #b, \
                                         fmt::format("({} vs {})", (a), (b)));  \
        }                                                                       \
    } while (false)
