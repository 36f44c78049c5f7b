# Precompiles the headers of the standard library, Qt and Eigen that nearly every source includes, once for
# each family of targets. They take most of the compile time. Sources still include what they need: the
# presets `headless` and `fuzz` compile without precompiled headers.
option(DIPWRIGHT_PRECOMPILE "Compile headers that nearly all sources include once for all" ON)

# dipwright_precompiled(FAMILY LINK … FOLDERS … HEADERS …)
#   Adds the headers of one family to the headers of all families, and the FOLDERS that contain them. Qt Gui
#   and Widgets are not linked, because linking them changes macros.
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
