# write_all_headers(FOLDER OUTPUT): one translation unit that includes every header of the core that may be installed.
function(write_all_headers FOLDER OUTPUT)
  file(GLOB_RECURSE HEADERS RELATIVE ${FOLDER} CONFIGURE_DEPENDS ${FOLDER}/patchmill/*.h)
  list(FILTER HEADERS EXCLUDE REGEX "/flute_(lanes|newton|rows|search)\\.h$")  # parts of flute_lanes_*.cpp
  list(SORT HEADERS)
  set(TEXT "// Made by cmake/AllHeaders.cmake.\n")
  foreach(HEADER ${HEADERS})
    string(APPEND TEXT "#include \"${HEADER}\"\n")
  endforeach()
  file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT "${TEXT}")
endfunction()
