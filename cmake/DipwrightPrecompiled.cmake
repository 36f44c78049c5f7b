# What nearly every source includes of the standard library, of Qt's core and of Eigen: most of the
# time of compiling one goes into these, so they are compiled once for all rooms and tests that know
# Qt. Sources name what they need all the same; the presets `headless` and `fuzz` compile without this.
option(DIPWRIGHT_PRECOMPILE "Compile headers that nearly all sources include once for all" ON)

if(DIPWRIGHT_PRECOMPILE)
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/Precompiled.cpp CONTENT "// A library has a source.\n")
    add_library(dipwright_precompiled STATIC ${PROJECT_BINARY_DIR}/Precompiled.cpp)
    target_link_libraries(dipwright_precompiled PRIVATE dipwright_options Qt6::Core Eigen3::Eigen)
    # By its path, and not linked: the macros would be others than where Qt Gui is not linked.
    target_include_directories(dipwright_precompiled SYSTEM PRIVATE ${Qt6Gui_INCLUDE_DIRS})
    target_precompile_headers(dipwright_precompiled PRIVATE <Eigen/Dense>
        <algorithm> <array> <cmath> <functional> <map> <memory> <mutex> <numeric> <optional> <vector>
        <QCoreApplication> <QDir> <QFile> <QFileInfo> <QJsonArray> <QJsonDocument> <QJsonObject>
        <QStringList> <QtGui/QImage>)
endif()

# dipwright_precompile(TARGET …)
function(dipwright_precompile)
    if(DIPWRIGHT_PRECOMPILE)
        foreach(target IN LISTS ARGN)
            target_precompile_headers(${target} REUSE_FROM dipwright_precompiled)
        endforeach()
    endif()
endfunction()
