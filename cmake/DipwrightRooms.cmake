# Makes a room includable only by the rooms that link it. A room is a folder of core, solvers, app or
# plugins, or `parallel` below these, with its own target. Its headers are included by their path below
# core, solvers or app: "film/DippedFilm.h", "parallel/ParallelFor.h".
# The include path is not the source tree, where all rooms are side by side. It is a folder in the build
# tree with one forwarding file for each header of the room:
#   rooms/TARGET/public/film/DippedFilm.h   for targets that link the room
#   rooms/TARGET/private/film/Ledger.h      for the room itself, and for tests that say INSIDE TARGET
# A room that does not link another room cannot include it: its build fails.

# dipwright_room(TARGET SOURCES … PRIVATE_HEADERS …)
#   Makes these folders and adds them to TARGET. The room consists of the folders of SOURCES, or of the
#   current folder without SOURCES. The next build finds a new header.
function(dipwright_room target)
    cmake_parse_arguments(ROOM "" "" "SOURCES;PRIVATE_HEADERS" ${ARGN})
    set(forwards ${PROJECT_BINARY_DIR}/rooms/${target})
    set(folders "")
    foreach(source IN LISTS ROOM_SOURCES ROOM_PRIVATE_HEADERS)
        cmake_path(ABSOLUTE_PATH source NORMALIZE)
        cmake_path(GET source PARENT_PATH folder)
        list(APPEND folders ${folder})
    endforeach()
    list(REMOVE_DUPLICATES folders)
    if(NOT folders)
        set(folders ${CMAKE_CURRENT_SOURCE_DIR})
    endif()
    list(TRANSFORM ROOM_PRIVATE_HEADERS PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)

    set(written "")
    foreach(folder IN LISTS folders)
        cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE prefix)
        string(REGEX REPLACE "^(core|solvers|app)/" "" prefix ${prefix})
        file(GLOB headers CONFIGURE_DEPENDS ${folder}/*.h ${folder}/*.cuh)
        foreach(header IN LISTS headers ROOM_PRIVATE_HEADERS)
            set(side public)
            if(header IN_LIST ROOM_PRIVATE_HEADERS)
                set(side private)
            endif()
            cmake_path(GET header FILENAME file)
            cmake_path(GET header PARENT_PATH home)
            if(home STREQUAL folder)
                # Written only if its content changes, so that nothing is rebuilt.
                # Relative, so that a compiler cache also matches another checkout.
                cmake_path(RELATIVE_PATH header BASE_DIRECTORY ${forwards}/${side}/${prefix}
                    OUTPUT_VARIABLE there)
                file(CONFIGURE OUTPUT ${forwards}/${side}/${prefix}/${file}
                    CONTENT "#include \"${there}\"\n")
                list(APPEND written ${forwards}/${side}/${prefix}/${file})
            endif()
        endforeach()
    endforeach()
    file(GLOB_RECURSE stale ${forwards}/*)
    list(REMOVE_ITEM stale "" ${written})
    if(stale)
        file(REMOVE ${stale})
    endif()

    get_target_property(type ${target} TYPE)
    if(type STREQUAL "INTERFACE_LIBRARY")
        target_include_directories(${target} INTERFACE ${forwards}/public)
    elseif(type STREQUAL "STATIC_LIBRARY")
        target_include_directories(${target} PUBLIC ${forwards}/public PRIVATE ${forwards}/private)
    else()
        target_include_directories(${target} PRIVATE ${forwards}/public ${forwards}/private)
    endif()
    set_property(GLOBAL APPEND PROPERTY DIPWRIGHT_ROOMS ${target})
    set_target_properties(${target} PROPERTIES DIPWRIGHT_FOLDERS "${folders}"
        DIPWRIGHT_PRIVATE_HEADERS "${ROOM_PRIVATE_HEADERS}")
endfunction()

# dipwright_write_rooms()
#   Writes the rooms and their links to rooms.json, in the order of their declaration. tests/house compares
#   them with the includes of the sources. The keys are target properties: LINK_LIBRARIES lists everything
#   that a room links, INTERFACE_LINK_LIBRARIES what it passes on.
function(dipwright_write_rooms)
    get_property(rooms GLOBAL PROPERTY DIPWRIGHT_ROOMS)
    set(entries "")
    foreach(room IN LISTS rooms)
        set(entry "  {\"TARGET\": \"${room}\"")
        foreach(key TYPE DIPWRIGHT_FOLDERS DIPWRIGHT_PRIVATE_HEADERS INCLUDE_DIRECTORIES
                INTERFACE_INCLUDE_DIRECTORIES LINK_LIBRARIES INTERFACE_LINK_LIBRARIES)
            get_target_property(values ${room} ${key})
            if(NOT values)
                set(values "")
            endif()
            string(REPLACE ";" "\", \"" values "${values}")
            string(APPEND entry ",\n   \"${key}\": [\"${values}\"]")
        endforeach()
        list(APPEND entries "${entry}}")
    endforeach()
    list(JOIN entries ",\n" entries)
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/rooms.json CONTENT "[\n${entries}\n]\n")
endfunction()
