# The core as others use it. As a part of another project it is only configured: building it there takes as
# long as the core.
foreach(COMPILER c++ clang++)
  find_program(FOUND_${COMPILER} ${COMPILER})
  if(FOUND_${COMPILER})
    add_test(NAME core.consumer.${COMPILER}
             COMMAND ${CMAKE_CURRENT_LIST_DIR}/run installed ${PROJECT_BINARY_DIR} ${COMPILER})
    set_tests_properties(core.consumer.${COMPILER} PROPERTIES LABELS core TIMEOUT 300)
  endif()
endforeach()
add_test(NAME core.consumer.subproject COMMAND ${CMAKE_CURRENT_LIST_DIR}/run subproject-configured)
set_tests_properties(core.consumer.subproject PROPERTIES LABELS core TIMEOUT 120)
