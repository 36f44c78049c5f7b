# Shared settings of all targets: language level, warnings and output folders. Also defines the functions
# by which folders declare their library and their tests.
include(DipwrightRooms)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
set(DIPWRIGHT_PLUGIN_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin/plugins)
# Output folder of the samples (resources/samples): NAME.dipw, models/NAME.obj.
set(DIPWRIGHT_SAMPLE_FOLDER ${CMAKE_BINARY_DIR}/share/samples)
# Plugins that misbehave, for the tests, in a folder where no program searches.
set(DIPWRIGHT_BAD_MODULE_FOLDER ${CMAKE_BINARY_DIR}/tests/bad-modules)
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
    # The first fault ends the program: this halves the checking code and the compile time. In instrumented
    # code, GCC's warnings about uninitialised values and bounds are wrong too often.
    target_compile_options(dipwright_options INTERFACE
        -fsanitize=${DIPWRIGHT_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
        "$<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;-Wno-array-bounds>")
    target_link_options(dipwright_options INTERFACE -fsanitize=${DIPWRIGHT_SANITIZE})
    target_compile_definitions(dipwright_options INTERFACE DIPWRIGHT_SANITIZED)
endif()
target_compile_definitions(dipwright_options INTERFACE
    $<$<CXX_COMPILER_ID:MSVC>:_USE_MATH_DEFINES>)

# dipwright_library(NAME SOURCES … PRIVATE_HEADERS … PUBLIC … PRIVATE …)
#   Declares one room of core, solvers or app as a static library, without SOURCES as headers only.
#   PUBLIC lists the rooms that its headers include, PRIVATE the rooms that only its sources include.
#   PRIVATE_HEADERS belong to this room alone. A room that is not linked cannot be included (DipwrightRooms).
function(dipwright_library name)
    cmake_parse_arguments(LIB "" "" "SOURCES;PRIVATE_HEADERS;PUBLIC;PRIVATE" ${ARGN})
    if(LIB_SOURCES)
        add_library(${name} STATIC ${LIB_SOURCES})
        target_link_libraries(${name} PUBLIC ${LIB_PUBLIC} PRIVATE dipwright_options ${LIB_PRIVATE})
        file(RELATIVE_PATH place "${PROJECT_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}")
        if(place MATCHES "^app/(workbench|viewport)")
            dipwright_precompile(${name} widgets)
            dipwright_moc(${name})
        elseif(place MATCHES "^(core|app)/") # the others know no Qt
            dipwright_precompile(${name} core)
        endif()
    else()
        add_library(${name} INTERFACE)
        target_link_libraries(${name} INTERFACE ${LIB_PUBLIC})
    endif()
    dipwright_room(${name} SOURCES ${LIB_SOURCES} PRIVATE_HEADERS ${LIB_PRIVATE_HEADERS})
endfunction()

# dipwright_threads_meet_in(SOURCE …)
#   Marks sources of the current folder whose threads synchronise through a library that the thread
#   sanitizer cannot see (TBB, Qt). It then ignores the code from that library's headers, too, so that
#   it does not report half an exchange as a race. parallel/ForkAndJoin.h tells it what both halves do.
function(dipwright_threads_meet_in)
    if(DIPWRIGHT_SANITIZE MATCHES "thread")
        set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS -fno-sanitize=thread
            COMPILE_DEFINITIONS DIPWRIGHT_THREAD_SANITIZER SKIP_PRECOMPILE_HEADERS ON)
    endif()
endfunction()

# Platform macros for moc, for slots in #ifdef: moc does not read Qt's headers, which define them.
set(DIPWRIGHT_MOC_DEFINITIONS $<$<NOT:$<PLATFORM_ID:Windows>>:-DQ_OS_UNIX> $<$<PLATFORM_ID:Linux>:-DQ_OS_LINUX>
    $<$<PLATFORM_ID:Darwin>:-DQ_OS_MACOS> $<$<PLATFORM_ID:Windows>:-DQ_OS_WIN>)

# dipwright_moc(TARGET)
#   Runs moc on every header of the current folder for TARGET. AUTOMOC also reads all included headers,
#   which takes fifty times as long and gives the same result.
function(dipwright_moc target)
    file(GLOB headers CONFIGURE_DEPENDS *.h)
    set(includes "")
    set(results "")
    foreach(header IN LISTS headers)
        cmake_path(GET header STEM name)
        set(result ${CMAKE_CURRENT_BINARY_DIR}/${target}_moc/moc_${name}.cpp)
        cmake_path(RELATIVE_PATH header BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/${target}_moc)
        add_custom_command(OUTPUT ${result}
            COMMAND Qt6::moc --no-notes ${DIPWRIGHT_MOC_DEFINITIONS} -f${header} -o ${result}
                ${CMAKE_CURRENT_SOURCE_DIR}/${name}.h
            DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}.h COMMAND_EXPAND_LISTS VERBATIM)
        list(APPEND results ${result})
        string(APPEND includes "#include \"moc_${name}.cpp\"\n")
    endforeach()
    set(all ${CMAKE_CURRENT_BINARY_DIR}/${target}_moc/all.cpp)
    file(CONFIGURE OUTPUT ${all} CONTENT "${includes}")
    set_source_files_properties(${all} PROPERTIES OBJECT_DEPENDS "${results}")
    target_sources(${target} PRIVATE ${all})
endfunction()

# dipwright_moc_source(TARGET SOURCE)
#   Makes NAME.moc from SOURCE, NAME.cpp. NAME.cpp includes it at its end.
function(dipwright_moc_source target source)
    cmake_path(GET source STEM name)
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_moc)
    set(own $<FILTER:$<TARGET_PROPERTY:${target},COMPILE_DEFINITIONS>,EXCLUDE,^$>)
    set(definitions "$<$<BOOL:${own}>:-D$<JOIN:${own},;-D>>")
    add_custom_command(OUTPUT ${folder}/${name}.moc
        COMMAND Qt6::moc --no-notes ${DIPWRIGHT_MOC_DEFINITIONS} "${definitions}" -o ${folder}/${name}.moc
            ${CMAKE_CURRENT_SOURCE_DIR}/${source}
        DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${source} COMMAND_EXPAND_LISTS VERBATIM)
    set_source_files_properties(${source} PROPERTIES OBJECT_DEPENDS ${folder}/${name}.moc)
    target_include_directories(${target} PRIVATE ${folder})
endfunction()

# Compile options of the tests: little optimisation, since the speed of tests does not matter.
add_library(dipwright_test_compilation INTERFACE)
target_link_libraries(dipwright_test_compilation INTERFACE dipwright_options)
if(NOT MSVC AND NOT DIPWRIGHT_SANITIZE)
    target_compile_options(dipwright_test_compilation INTERFACE $<$<CONFIG:Release>:-O1>)
endif()
add_library(dipwright_test_options INTERFACE)
target_link_libraries(dipwright_test_options INTERFACE dipwright_test_compilation TestFolders Qt6::Test)

# dipwright_test_helper(NAME SOURCES … LINK …)
#   Declares a library that several tests share, named after its file: NAME.cpp, and other SOURCES.
function(dipwright_test_helper name)
    cmake_parse_arguments(HLP "" "" "SOURCES;LINK" ${ARGN})
    add_library(${name} STATIC ${name}.cpp ${HLP_SOURCES})
    target_include_directories(${name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
    target_link_libraries(${name} PUBLIC ${HLP_LINK} PRIVATE dipwright_test_options)
    dipwright_precompile(${name} test)
endfunction()

# dipwright_schedule(NAME WAITS COST)
#   Labels a test with the folders of its source below tests (`ctest -L sheet`, `ctest -L core`). Sets
#   how many of ctest's slots it takes: two, or one if WAITS is true. scripts/test gives ctest two slots
#   for each core and one more. So a waiting test can run beside one computing test for each core.
function(dipwright_schedule name waits cost)
    file(RELATIVE_PATH labels "${PROJECT_SOURCE_DIR}/tests" "${CMAKE_CURRENT_SOURCE_DIR}")
    string(REPLACE "/" ";" labels "${labels}")
    set(slots 2)
    if(waits)
        set(slots 1)
        list(APPEND labels waits)
    endif()
    set_tests_properties(${name} PROPERTIES LABELS "${labels}" PROCESSORS ${slots} COST "${cost}"
        FAIL_REGULAR_EXPRESSION "Totals: [0-2] passed, 0 failed, 0 skipped") # no case, but its frame
endfunction()

# dipwright_test(NAME [ON_SCREEN] [WAITS] SOURCES … LINK … INSIDE … NEEDS … ENVIRONMENT … COST …)
#   Declares a Qt Test program with class NAME in NAME.cpp (and other SOURCES). ctest runs it by this
#   name, without a display, or with ON_SCREEN on its own screen if there is xvfb-run. INSIDE names
#   rooms whose private headers it may include. NEEDS names targets that must exist when it runs.
#   ENVIRONMENT adds variables. COST is its time in seconds, if more than ten: ctest starts the longest
#   first. WAITS: it computes for less than half its time and otherwise waits.
find_program(DIPWRIGHT_XVFB_RUN xvfb-run)
set(DIPWRIGHT_TEST_SECONDS 900)
if(DIPWRIGHT_SANITIZE) # slows programs down up to twenty times
    set(DIPWRIGHT_TEST_SECONDS 7200)
endif()
function(dipwright_test name)
    cmake_parse_arguments(TST "ON_SCREEN;WAITS" "COST" "SOURCES;LINK;INSIDE;NEEDS;ENVIRONMENT" ${ARGN})
    add_executable(${name} ${name}.cpp ${TST_SOURCES})
    set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
    target_link_libraries(${name} PRIVATE dipwright_test_options ${TST_LINK} ${TST_INSIDE})
    dipwright_moc_source(${name} ${name}.cpp)
    dipwright_precompile(${name} test)
    foreach(room IN LISTS TST_INSIDE)
        target_include_directories(${name} PRIVATE ${PROJECT_BINARY_DIR}/rooms/${room}/private)
    endforeach()
    # Every test that reads a model or a picture starts the reader.
    add_dependencies(${name} dipwright-reader ${TST_NEEDS})
    set(launcher "")
    set(platform QT_QPA_PLATFORM=offscreen)
    if(TST_ON_SCREEN AND DIPWRIGHT_XVFB_RUN)
        set(launcher ${DIPWRIGHT_XVFB_RUN} -a -s "-screen 0 1600x1000x24")
        set(platform QT_QPA_PLATFORM=xcb)
    endif()
    add_test(NAME ${name} COMMAND ${launcher} $<TARGET_FILE:${name}>)
    # Qt Test's own timeout is five minutes for each case, which a busy machine can exceed.
    dipwright_schedule(${name} ${TST_WAITS} "${TST_COST}")
    set_tests_properties(${name} PROPERTIES TIMEOUT ${DIPWRIGHT_TEST_SECONDS}
        ENVIRONMENT "${platform};QTEST_FUNCTION_TIMEOUT=${DIPWRIGHT_TEST_SECONDS}000;DIPWRIGHT_PLUGIN_PATH=${DIPWRIGHT_PLUGIN_OUTPUT_DIRECTORY};${TST_ENVIRONMENT}")
endfunction()
