# The target dipwright_vtk_qt: VTK's own Qt 6 widget, QVTKOpenGLNativeWidget.
#
# Where VTK comes with GUISupportQt for Qt 6, that is used. Where it was built for another Qt, the
# widget's unmodified source is compiled from DIPWRIGHT_VTK_QT_SOURCE (scripts/fetch-vtk-qt).

set(DIPWRIGHT_VTK_QT_SOURCE ${PROJECT_SOURCE_DIR}/build/vtk-qt CACHE PATH
    "Folder with the source of VTK's GUISupport/Qt, where VTK comes without it for Qt 6")

set(DIPWRIGHT_VTK_VIEW_COMPONENTS
    CommonCore CommonColor CommonDataModel CommonTransforms CommonExecutionModel FiltersCore
    FiltersSources InteractionStyle InteractionWidgets RenderingAnnotation RenderingCore
    RenderingFreeType RenderingOpenGL2 RenderingUI)
find_package(VTK 9.1 REQUIRED COMPONENTS ${DIPWRIGHT_VTK_VIEW_COMPONENTS})
list(TRANSFORM DIPWRIGHT_VTK_VIEW_COMPONENTS PREPEND VTK:: OUTPUT_VARIABLE DIPWRIGHT_VTK_VIEW_MODULES)

set(vtk_qt_libraries "")
if(TARGET VTK::GUISupportQt)
    get_target_property(vtk_qt_libraries VTK::GUISupportQt INTERFACE_LINK_LIBRARIES)
endif()

if("${vtk_qt_libraries}" MATCHES "Qt6::")
    add_library(dipwright_vtk_qt INTERFACE)
    target_link_libraries(dipwright_vtk_qt INTERFACE VTK::GUISupportQt)
else()
    if(NOT EXISTS ${DIPWRIGHT_VTK_QT_SOURCE}/QVTKOpenGLNativeWidget.cxx)
        message(FATAL_ERROR "This VTK has no widget for Qt 6, and its source is not in "
            "${DIPWRIGHT_VTK_QT_SOURCE}: run scripts/fetch-vtk-qt, or configure with -DDIPWRIGHT_WORKBENCH=OFF")
    endif()
    add_library(dipwright_vtk_qt STATIC
        ${DIPWRIGHT_VTK_QT_SOURCE}/QVTKInteractor.cxx
        ${DIPWRIGHT_VTK_QT_SOURCE}/QVTKInteractorAdapter.cxx
        ${DIPWRIGHT_VTK_QT_SOURCE}/QVTKInteractorInternal.h
        ${DIPWRIGHT_VTK_QT_SOURCE}/QVTKOpenGLNativeWidget.cxx
        ${DIPWRIGHT_VTK_QT_SOURCE}/QVTKRenderWindowAdapter.cxx)
    set_target_properties(dipwright_vtk_qt PROPERTIES AUTOMOC ON)
    target_include_directories(dipwright_vtk_qt SYSTEM PUBLIC
        ${DIPWRIGHT_VTK_QT_SOURCE} ${CMAKE_CURRENT_LIST_DIR}/vtk-qt)
    target_compile_definitions(dipwright_vtk_qt PRIVATE QT_NO_KEYWORDS)
    target_link_libraries(dipwright_vtk_qt PUBLIC
        Qt6::Widgets Qt6::OpenGLWidgets ${DIPWRIGHT_VTK_VIEW_MODULES})
endif()
