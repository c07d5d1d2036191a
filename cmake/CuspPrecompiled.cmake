# SPDX-License-Identifier: GPL-3.0-or-later
# Headers of others, parsed once instead of once a file, which takes a third off a build from nothing. Headers of ours stay
# out: they change. The preset "dev" does without, so that a file that forgets an include fails to compile there.
#
# precompile(GROUP LIBS libraries HEADERS headers): the target GROUP holds these headers, as who links these libraries
# sees them.
function(precompile group)
    cmake_parse_arguments(arg "" "" "LIBS;HEADERS" ${ARGN})
    file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/${group}.cpp CONTENT "")
    add_library(${group} OBJECT EXCLUDE_FROM_ALL ${CMAKE_BINARY_DIR}/${group}.cpp)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        # It looks at macros that each test defines for itself, which GCC does not allow.
        list(REMOVE_ITEM arg_HEADERS QtTest/QTest)
    endif()
    list(TRANSFORM arg_HEADERS REPLACE "(.+)" "<\\1>")
    target_precompile_headers(${group} PRIVATE ${arg_HEADERS})
    # Without their time the same headers are the same file, and ccache knows what was built with them.
    target_compile_options(${group} PRIVATE $<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>)
    target_link_libraries(${group} PRIVATE ${arg_LIBS} cusp_flags)
    add_dependencies(tidy_inputs ${group})
endfunction()

# use_precompiled(TARGET GROUP): TARGET must link the libraries of GROUP, and be compiled with no other options.
function(use_precompiled target group)
    if(CUSP_PRECOMPILE)
        target_precompile_headers(${target} REUSE_FROM ${group})
        # ccache asks for this, to see what the headers hold.
        target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
    endif()
endfunction()

set(standard_headers
    algorithm array atomic bit cerrno charconv chrono cmath cstddef cstdint cstdio cstdlib cstring deque filesystem
    fstream functional limits map memory mutex numbers numeric optional set span string string_view system_error thread
    type_traits unordered_map utility variant vector
    glm/common.hpp glm/ext/vector_int2.hpp glm/geometric.hpp glm/gtc/matrix_transform.hpp glm/mat3x3.hpp
    glm/mat4x4.hpp glm/matrix.hpp glm/trigonometric.hpp glm/vec2.hpp glm/vec3.hpp glm/vec4.hpp
    glm/vector_relational.hpp tl/expected.hpp)
set(qt_headers
    QByteArray QCoreApplication QDateTime QDir QElapsedTimer QFile QFileInfo QJsonArray QJsonDocument QJsonObject QList
    QObject QProcess QSet QString QStringList QTemporaryDir QThread QTimer QVariant
    # By its folder, which all who see Qt have: only tests link it.
    QtTest/QTest)
set(window_headers
    QAction QApplication QBrush QColor QFont QFrame QHBoxLayout QIcon QImage QKeyEvent QLabel QMouseEvent
    QOpenGLBuffer QOpenGLFramebufferObject QOpenGLFunctions_3_3_Core QOpenGLShaderProgram QOpenGLTexture
    QOpenGLVertexArrayObject QOpenGLWidget QPainter QPainterPath QPalette QPixmap QPointF QPushButton QRect
    QScrollArea QSlider QSize QToolButton QVBoxLayout QWidget)
