# SPDX-License-Identifier: GPL-3.0-or-later
# The parts of OpenCV that head tracking uses. Debian has CMake's files for OpenCV in a package with all of it, so the
# parts are looked for one by one. Sets OpenCvParts_FOUND and makes the targets opencv_pose and opencv_pictures.
find_path(opencv_include opencv2/videoio.hpp PATH_SUFFIXES opencv4)
set(opencv_files opencv_include)
foreach(part core imgproc calib3d imgcodecs videoio)
    find_library(opencv_${part}_file opencv_${part})
    list(APPEND opencv_files opencv_${part}_file)
endforeach()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenCvParts REQUIRED_VARS ${opencv_files})
mark_as_advanced(${opencv_files})
if(OpenCvParts_FOUND AND NOT TARGET opencv_pose)
    add_library(opencv_pose INTERFACE IMPORTED)
    set_target_properties(opencv_pose PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${opencv_include})
    target_link_libraries(opencv_pose INTERFACE ${opencv_calib3d_file} ${opencv_core_file})
    add_library(opencv_pictures INTERFACE IMPORTED)
    set_target_properties(opencv_pictures PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${opencv_include})
    target_link_libraries(opencv_pictures INTERFACE
        ${opencv_videoio_file} ${opencv_imgcodecs_file} ${opencv_imgproc_file} ${opencv_core_file})
endif()
