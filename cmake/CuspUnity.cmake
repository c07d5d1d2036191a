# SPDX-License-Identifier: GPL-3.0-or-later
# Unity builds: the sources of a folder are compiled together, up to twelve at a time, which takes a third of the time that
# compiling each alone takes. The price: files of one folder may not use the same name at file scope. The presets "dev" and
# "lint" compile each file alone, so that a file that lacks an include still fails to compile there.

# compile_together(TARGET [EXCEPT regular expression of sources]): call it after the target has its sources.
function(compile_together target)
    cmake_parse_arguments(arg "" "EXCEPT" "" ${ARGN})
    if(NOT CUSP_UNITY)
        return()
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    get_target_property(sources ${target} SOURCES)
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
    if(arg_EXCEPT)
        list(FILTER sources EXCLUDE REGEX "${arg_EXCEPT}")
    endif()
    list(SORT sources)
    foreach(source IN LISTS sources)
        cmake_path(GET source PARENT_PATH folder)
        string(MD5 key "${folder}")
        math(EXPR count_${key} "0${count_${key}} + 1")
        math(EXPR part "(${count_${key}} - 1) / 12")
        cmake_path(GET folder FILENAME name)
        set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${name}_${part})
    endforeach()
endfunction()
