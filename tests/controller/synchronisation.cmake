# Synchronisation that a real controller holds: programs made by the core, run through LinuxCNC.
add_executable(make_program ${CMAKE_CURRENT_LIST_DIR}/make_program.cpp
               ${CMAKE_CURRENT_LIST_DIR}/bezier.cpp)
target_link_libraries(make_program PRIVATE patchmill_core)

add_executable(make_five_axis ${CMAKE_CURRENT_LIST_DIR}/make_five_axis.cpp
               ${CMAKE_CURRENT_LIST_DIR}/bezier.cpp)
target_link_libraries(make_five_axis PRIVATE patchmill_core)

foreach(GROUP SpindleLocked ConstantFeed Calibration Harness)
  add_test(NAME controller.synchronisation.${GROUP}
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/synchronisation_test.py ${GROUP})
  set_tests_properties(controller.synchronisation.${GROUP} PROPERTIES LABELS controller TIMEOUT 300
                       ENVIRONMENT "MAKE_PROGRAM=$<TARGET_FILE:make_program>")
endforeach()

foreach(GROUP TipInWork FormsAgree PhaseWithCTurning)
  add_test(NAME controller.five_axis.${GROUP}
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/five_axis_test.py ${GROUP})
  set_tests_properties(controller.five_axis.${GROUP} PROPERTIES LABELS controller TIMEOUT 300
                       ENVIRONMENT "MAKE_FIVE_AXIS=$<TARGET_FILE:make_five_axis>")
endforeach()
