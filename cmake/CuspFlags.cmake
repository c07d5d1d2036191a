# SPDX-License-Identifier: GPL-3.0-or-later
# One INTERFACE target with the warnings, sanitizers and floating-point rules that every target of ours links.
add_library(cusp_flags INTERFACE)
target_compile_options(cusp_flags INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
    # A recording must replay to the same bits everywhere: no fused multiply-add behind our back.
    -ffp-contract=off)
# Debug builds check the index of every vector and array.
target_compile_definitions(cusp_flags INTERFACE $<$<CONFIG:Debug>:_GLIBCXX_ASSERTIONS>)
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(cusp_flags INTERFACE -Wno-psabi)
endif()
# A quarter of the time that the usual linker takes, for two hundred programs, most of them tests.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=gold CUSP_HAS_GOLD)
if(CUSP_HAS_GOLD)
    target_link_options(cusp_flags INTERFACE -fuse-ld=gold)
endif()
if(CUSP_SANITIZE)
    target_compile_options(cusp_flags INTERFACE -fsanitize=${CUSP_SANITIZE} -fno-omit-frame-pointer)
    if(CUSP_SANITIZE MATCHES "undefined")
        target_compile_options(cusp_flags INTERFACE -fno-sanitize-recover=undefined)
    endif()
    target_link_options(cusp_flags INTERFACE -fsanitize=${CUSP_SANITIZE})
endif()
if(CUSP_FUZZ)
    if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
        message(FATAL_ERROR "CUSP_FUZZ needs Clang: libFuzzer is part of it. Use the preset 'fuzz'.")
    endif()
    target_compile_options(cusp_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()
if(CUSP_COVERAGE)
    target_compile_options(cusp_flags INTERFACE --coverage)
    target_link_options(cusp_flags INTERFACE --coverage)
endif()
