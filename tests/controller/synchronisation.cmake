# Synchronisation that a real controller holds: programs made by the core, run through LinuxCNC.
add_executable(make_program ${CMAKE_CURRENT_LIST_DIR}/make_program.cpp
               ${CMAKE_CURRENT_LIST_DIR}/bezier.cpp)
target_link_libraries(make_program PRIVATE patchmill_core)

foreach(GROUP SpindleLocked ConstantFeed Calibration Harness)
  add_test(NAME controller.synchronisation.${GROUP}
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/synchronisation_test.py ${GROUP})
  set_tests_properties(controller.synchronisation.${GROUP} PROPERTIES LABELS controller TIMEOUT 300
                       ENVIRONMENT "MAKE_PROGRAM=$<TARGET_FILE:make_program>")
endforeach()
