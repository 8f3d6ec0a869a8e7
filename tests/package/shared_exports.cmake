cmake_minimum_required(VERSION 3.25)

# The shared library shows what the public headers declare, and nothing else: no class of a private
# header, nothing of the libraries that are linked in, no template of the standard library.
execute_process(COMMAND ${NM} --dynamic --defined-only --extern-only --demangle ${LIBRARY}
    OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
foreach(public "frostfill::fill(" "frostfill::Simulation::step(" "frostfill::exportRun(" "frostfill::OperationCounts::operator-("
        "typeinfo for frostfill::Error" "vtable for frostfill::PngSequence")
    string(FIND "${text}" "${public}" at)
    if(at EQUAL -1)
        message(SEND_ERROR "${LIBRARY} does not show ${public}")
    endif()
endforeach()
string(REGEX MATCHALL "[^\n]+" lines "${text}")
foreach(line IN LISTS lines)
    if(NOT line MATCHES "^[0-9a-f]+ [A-Za-z] (non-virtual thunk to |virtual thunk to |(vtable|typeinfo|typeinfo name) for )?frostfill::"
       AND NOT line MATCHES " FROSTFILL_[0-9.]+$")
        message(SEND_ERROR "not of namespace frostfill: ${line}")
    endif()
    if(line MATCHES "frostfill::(World|Releases|FastEngine|Pipeline|AtomicFile|embedded)(::|\\()")
        message(SEND_ERROR "of a private header: ${line}")
    endif()
endforeach()
