# What nearly every source includes of the standard library, of Qt and of Eigen: most of the time of
# compiling one goes into these, so they are compiled once for each family of targets. Sources name what
# they need all the same; the presets `headless` and `fuzz` compile without this.
option(DIPWRIGHT_PRECOMPILE "Compile headers that nearly all sources include once for all" ON)

# dipwright_precompiled(FAMILY LINK … FOLDERS … HEADERS …)
#   The headers of a family, beside those that all families have. FOLDERS are where they lie: Qt Gui and
#   Widgets are not linked, since their macros would be others than where they are not linked.
function(dipwright_precompiled family)
    cmake_parse_arguments(PCH "" "" "LINK;FOLDERS;HEADERS" ${ARGN})
    set(target dipwright_precompiled_${family})
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/Precompiled.cpp CONTENT "// A library has a source.\n")
    add_library(${target} STATIC ${PROJECT_BINARY_DIR}/Precompiled.cpp)
    target_link_libraries(${target} PRIVATE ${PCH_LINK} Qt6::Core Eigen3::Eigen)
    target_include_directories(${target} SYSTEM PRIVATE ${PCH_FOLDERS})
    target_precompile_headers(${target} PRIVATE <Eigen/Dense>
        <algorithm> <array> <cmath> <functional> <map> <memory> <mutex> <numeric> <optional> <vector>
        <QCoreApplication> <QDir> <QFile> <QFileInfo> <QJsonArray> <QJsonDocument> <QJsonObject>
        <QStringList> <QtGui/QImage> ${PCH_HEADERS})
endfunction()

if(DIPWRIGHT_PRECOMPILE)
    dipwright_precompiled(core LINK dipwright_options FOLDERS ${Qt6Gui_INCLUDE_DIRS})
    if(BUILD_TESTING)
        dipwright_precompiled(test LINK dipwright_test_compilation Qt6::Test FOLDERS ${Qt6Gui_INCLUDE_DIRS}
            HEADERS <QtCore/QtCore> <QtTest/qsignalspy.h> <QtTest/qtestcase.h> <QtTest/qtestdata.h>)
    endif()
    if(DIPWRIGHT_WORKBENCH)
        dipwright_precompiled(widgets LINK dipwright_options
            FOLDERS ${Qt6Gui_INCLUDE_DIRS} ${Qt6Widgets_INCLUDE_DIRS}
            HEADERS <QLocale> <QTimer> <QtGui/QAction> <QtGui/QPainter> <QtWidgets/QApplication>
                <QtWidgets/QBoxLayout> <QtWidgets/QCheckBox> <QtWidgets/QComboBox> <QtWidgets/QDialog>
                <QtWidgets/QDialogButtonBox> <QtWidgets/QFileDialog> <QtWidgets/QFormLayout>
                <QtWidgets/QHeaderView> <QtWidgets/QLabel> <QtWidgets/QLineEdit>
                <QtWidgets/QPushButton> <QtWidgets/QTableWidget> <QtWidgets/QToolButton>)
    endif()
endif()

# dipwright_precompile(TARGET FAMILY)
function(dipwright_precompile target family)
    if(DIPWRIGHT_PRECOMPILE)
        target_precompile_headers(${target} REUSE_FROM dipwright_precompiled_${family})
    endif()
endfunction()
