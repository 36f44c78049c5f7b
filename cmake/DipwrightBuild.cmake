# What every target of the project shares: the language level, the warnings, where binaries go,
# and the two functions with which folders declare their library and their tests.
include(DipwrightRooms)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
# moc 6.4 stumbles over <concepts> of GCC 12 in C++20; it needs nothing from there.
set(CMAKE_AUTOMOC_MOC_OPTIONS -D_GLIBCXX_CONCEPTS)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
set(DIPWRIGHT_PLUGIN_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin/plugins)
# Where the samples are made (resources/samples): NAME.dipw, models/NAME.obj.
set(DIPWRIGHT_SAMPLE_FOLDER ${CMAKE_BINARY_DIR}/share/samples)
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
endif()

add_library(dipwright_options INTERFACE)
if(MSVC)
    target_compile_options(dipwright_options INTERFACE /W4 /permissive- $<$<BOOL:${DIPWRIGHT_WERROR}>:/WX>)
else()
    # -ffp-contract=off keeps results the same between machines with and without fused multiply-add.
    target_compile_options(dipwright_options INTERFACE
        $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
        -fno-math-errno -ffp-contract=off
        $<$<BOOL:${DIPWRIGHT_WERROR}>:-Werror>>)
endif()
if(DIPWRIGHT_SANITIZE)
    # GCC's warning about uninitialised values is wrong too often in code that it instruments.
    target_compile_options(dipwright_options INTERFACE -fsanitize=${DIPWRIGHT_SANITIZE} -fno-omit-frame-pointer
        $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    target_link_options(dipwright_options INTERFACE -fsanitize=${DIPWRIGHT_SANITIZE})
endif()
target_compile_definitions(dipwright_options INTERFACE
    DIPWRIGHT_VERSION="${PROJECT_VERSION}" $<$<CXX_COMPILER_ID:MSVC>:_USE_MATH_DEFINES>)

# dipwright_library(NAME SOURCES … PRIVATE_HEADERS … PUBLIC … PRIVATE …)
#   One room of core, solvers or app as a static library; headers alone where there are no SOURCES.
#   PUBLIC are the rooms that its headers include, PRIVATE those that only its sources include;
#   PRIVATE_HEADERS are for this room alone. What is not linked cannot be included (DipwrightRooms).
function(dipwright_library name)
    cmake_parse_arguments(LIB "" "" "SOURCES;PRIVATE_HEADERS;PUBLIC;PRIVATE" ${ARGN})
    if(LIB_SOURCES)
        add_library(${name} STATIC ${LIB_SOURCES})
        target_link_libraries(${name} PUBLIC ${LIB_PUBLIC} PRIVATE dipwright_options ${LIB_PRIVATE})
    else()
        add_library(${name} INTERFACE)
        target_link_libraries(${name} INTERFACE ${LIB_PUBLIC})
    endif()
    dipwright_room(${name} SOURCES ${LIB_SOURCES} PRIVATE_HEADERS ${LIB_PRIVATE_HEADERS})
endfunction()

# dipwright_test(NAME SOURCES … LINK … INSIDE …)
#   A Qt Test program that ctest runs by the name NAME, without a display. ENVIRONMENT adds variables;
#   INSIDE names rooms whose private headers it sees as well.
function(dipwright_test name)
    cmake_parse_arguments(TST "" "" "SOURCES;LINK;INSIDE;ENVIRONMENT" ${ARGN})
    add_executable(${name} ${TST_SOURCES})
    set_target_properties(${name} PROPERTIES AUTOMOC ON
        RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
    target_link_libraries(${name} PRIVATE dipwright_options Qt6::Test ${TST_LINK} ${TST_INSIDE})
    foreach(room IN LISTS TST_INSIDE)
        target_include_directories(${name} PRIVATE ${PROJECT_BINARY_DIR}/rooms/${room}/private)
    endforeach()
    target_compile_definitions(${name} PRIVATE
        DIPWRIGHT_BINARY_FOLDER="${CMAKE_BINARY_DIR}/bin"
        DIPWRIGHT_RESOURCE_FOLDER="${PROJECT_SOURCE_DIR}/resources"
        DIPWRIGHT_SAMPLE_FOLDER="${DIPWRIGHT_SAMPLE_FOLDER}"
        DIPWRIGHT_SHARED_MODELS="${PROJECT_SOURCE_DIR}/../shared/data/models")
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES TIMEOUT 600
        ENVIRONMENT "QT_QPA_PLATFORM=offscreen;DIPWRIGHT_PLUGIN_PATH=${DIPWRIGHT_PLUGIN_OUTPUT_DIRECTORY};${TST_ENVIRONMENT}")
endfunction()
