cmake_minimum_required(VERSION 3.25)

# Who installs Frostfill gets nothing that measures it: nothing that the libraries of `frostfill fps` and
# of frostfill-lab define is in an installed one.
function(defined_functions library result)
    execute_process(COMMAND ${NM} --defined-only --extern-only --demangle ${library}
        OUTPUT_VARIABLE text ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
    # T: code of this library alone; what several may share (inline functions) is W.
    string(REGEX MATCHALL " T frostfill::[^\n(]+" functions "${text}")
    list(REMOVE_DUPLICATES functions)
    set(${result} "${functions}" PARENT_SCOPE)
endfunction()

foreach(library IN LISTS APART)
    defined_functions(${library} functions)
    list(APPEND studies ${functions})
endforeach()
foreach(known measureFps measurePeers measureClosedForms)
    if(NOT " T frostfill::${known}" IN_LIST studies)
        message(FATAL_ERROR "nothing defines ${known}: this test looks for nothing")
    endif()
endforeach()

foreach(component core render)
    set(library ${LIBRARIES}/libfrostfill_${component}.a)
    defined_functions(${library} installed)
    list(LENGTH installed count)
    if(count LESS 50)
        message(FATAL_ERROR "${library} defines ${count} functions only: is it a library of ours?")
    endif()
    foreach(function IN LISTS studies)
        if(function IN_LIST installed)
            message(SEND_ERROR "${library} has${function}, which belongs to the studies")
        endif()
    endforeach()
endforeach()

# And core asks its consumer for no library that only pictures use.
file(STRINGS ${LIBRARIES}/cmake/frostfill/frostfill-core.cmake asked REGEX "INTERFACE_LINK_LIBRARIES")
if(NOT asked MATCHES "assimp" OR asked MATCHES "DEFLATE|ISAL|STB|glm|nlohmann")
    message(SEND_ERROR "frostfill::core asks for:${asked}")
endif()
