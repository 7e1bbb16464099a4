# How Glint's own code is compiled: code generation, warnings, sanitizers, compiler cache and linker.
# glint_codegen goes to every target, CUDA's host pass included; glint_warnings to every target of ours in C++.

find_program(GLINT_CCACHE ccache)
if(GLINT_CCACHE)
    # With precompiled headers, ccache hits only if it may trust their content, which is never twice the same.
    set(ccache_launcher ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_PCH_EXTSUM=1
        ${GLINT_CCACHE})
    foreach(language CXX CUDA)
        if(NOT DEFINED CMAKE_${language}_COMPILER_LAUNCHER)
            set(CMAKE_${language}_COMPILER_LAUNCHER ${ccache_launcher})
        endif()
    endforeach()
endif()

# The linker stays the compiler's own: lld 14 keeps one unwind entry for each address, and where GCC leaves an empty cold
# part it keeps that one, so that an exception which passes the function beside it aborts.

# A test that draws nothing should not load Mesa.
add_link_options(LINKER:--as-needed)

set(CMAKE_CXX_FLAGS_RELEASE "-O3 -g0 -DNDEBUG")

set(codegen_flags "")
if(GLINT_NATIVE)
    list(APPEND codegen_flags -march=native)
else()
    list(APPEND codegen_flags -march=x86-64-v3)
endif()
# Never -ffast-math: it deletes the checks for NaN and infinity. These two change no result.
list(APPEND codegen_flags -fno-math-errno -fno-trapping-math)
# No contraction: a*b - c*d must be antisymmetric in its two products (watertight edge functions), and the CPU and nvcc's
# host pass must compute the same bits. Where a fused operation pays, the code says std::fma.
list(APPEND codegen_flags -ffp-contract=off)

if(GLINT_SANITIZE STREQUAL "address")
    set(sanitizer_flags -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
elseif(GLINT_SANITIZE STREQUAL "thread")
    set(sanitizer_flags -fsanitize=thread -fno-omit-frame-pointer)
elseif(GLINT_SANITIZE STREQUAL "")
    set(sanitizer_flags "")
else()
    message(FATAL_ERROR "GLINT_SANITIZE is \"${GLINT_SANITIZE}\"; expected \"\", address or thread.")
endif()

# GCC collects its garbage from 512 MiB on, not as soon as it can: 3 to 8 % of the time of large sources.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options($<$<COMPILE_LANGUAGE:CXX>:--param=ggc-min-heapsize=524288>)
endif()

# CUDA's host pass gets the same flags: inline functions that both compilers emit are merged by the linker, and it
# must not matter which copy it keeps.
add_library(glint_codegen INTERFACE)
foreach(flag IN LISTS codegen_flags sanitizer_flags)
    target_compile_options(glint_codegen INTERFACE
        $<$<COMPILE_LANGUAGE:CXX>:${flag}> $<$<COMPILE_LANGUAGE:CUDA>:-Xcompiler=${flag}>)
endforeach()
target_compile_definitions(glint_codegen INTERFACE $<$<CONFIG:Debug>:_GLIBCXX_ASSERTIONS>)
target_link_options(glint_codegen INTERFACE ${sanitizer_flags})

# Left out: -Wconversion and -Wsign-conversion, which reject every int that becomes a float or an index. Their two
# useful parts stay: a float that is cut to an int, and a double that slips into float arithmetic.
set(warning_flags -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wfloat-conversion -Wundef -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Clang's takes double{x} for a slip, too.
    list(APPEND warning_flags -Wdouble-promotion)
    # GCC 12 sees overlapping and endless copies in "text" + std::string (GCC bugs 105329 and 105651).
    list(APPEND warning_flags -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds)
    if(GLINT_SANITIZE)
        # The sanitizers' own checks look like uses of uninitialised variables to it.
        list(APPEND warning_flags -Wno-maybe-uninitialized)
    endif()
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    # OpenEXR's own initialiser leaves fields out.
    list(APPEND warning_flags -Wno-missing-field-initializers)
endif()
add_library(glint_warnings INTERFACE)
foreach(flag IN LISTS warning_flags)
    target_compile_options(glint_warnings INTERFACE $<$<COMPILE_LANGUAGE:CXX>:${flag}>)
endforeach()

# glint_precompile_headers(TARGET HEADER…): with a sum that ccache takes for the content of the compiled header.
function(glint_precompile_headers target)
    target_precompile_headers(${target} PRIVATE ${ARGN})
    file(SHA256 ${PROJECT_SOURCE_DIR}/engine/base/precompiled.h ours)
    file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${target}.dir/cmake_pch.hxx.gch.sum
        CONTENT "${CMAKE_CXX_COMPILER_VERSION} ${ARGN} ${ours}\n")
endfunction()

# glint_compile_soon(TARGET): less optimisation, for code in which nobody waits; saves about a third of its time. It needs a compiled
# header of its own: GCC takes up the level that a header was compiled with.
function(glint_compile_soon target)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# glint_unite(TARGET SIZE EXCLUDE REGEX): compiles the target's sources together, SIZE at a time of one folder in
# alphabetical order, but for those whose path matches REGEX. Most of a small file's time goes to the templates that
# its neighbours use too. Sources with definitions of their own stay apart (CMake sees to it).
function(glint_unite target size exclude regex)
    if(NOT GLINT_UNITY)
        return()
    endif()
    get_target_property(sources ${target} SOURCES)
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
    list(FILTER sources EXCLUDE REGEX "${regex}")
    list(SORT sources)
    set(folder "")
    foreach(source IN LISTS sources)
        get_filename_component(of ${source} DIRECTORY)
        if(NOT of STREQUAL folder)
            set(folder ${of})
            set(count 0)
        endif()
        math(EXPR batch "${count} / ${size}")
        math(EXPR count "${count} + 1")
        get_filename_component(name ${folder} NAME)
        set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${name}_${batch})
    endforeach()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
