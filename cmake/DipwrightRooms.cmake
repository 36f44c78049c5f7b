# A room is a folder of core, solvers, app or plugins, or `parallel` below these, with a target of
# its own. Its headers are included by their path below core, solvers or app:
# "film/DippedFilm.h", "parallel/ParallelFor.h". They are not reached through the source tree, where every room lies beside every other, but through a
# folder in the build tree that has, for each header of this one room, a file that includes it:
#   rooms/TARGET/public/film/DippedFilm.h   for whoever links the target
#   rooms/TARGET/private/film/Ledger.h      for the room itself, and for tests that say INSIDE TARGET
# So a room that does not link another cannot include it: its build fails.

# dipwright_room(TARGET SOURCES … PRIVATE_HEADERS …)
#   Makes these folders and gives them to TARGET. The room is the folders in which SOURCES lie, or
#   the current one where there are none. A new header is found at the next build.
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
                # Touched only where it says something new, so that nothing is built again for it.
                # Relative, so that a compiler cache finds it again from another checkout.
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
#   Writes what the rooms are and what they link into rooms.json, in the order in which they were
#   declared, for tests/house to hold against what their sources include. The keys are the targets'
#   properties: LINK_LIBRARIES is all that a room links, INTERFACE_LINK_LIBRARIES what it hands on.
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
