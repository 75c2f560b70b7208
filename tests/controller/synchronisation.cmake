# Synchronisation that a real controller holds: programs made by the core, run through LinuxCNC.
foreach(PROGRAM make_program make_five_axis)
  add_executable(${PROGRAM} ${CMAKE_CURRENT_LIST_DIR}/${PROGRAM}.cpp)
  patchmill_target(${PROGRAM})
  target_include_directories(${PROGRAM} PRIVATE ${PROJECT_SOURCE_DIR}/tests/core)
  target_link_libraries(${PROGRAM} PRIVATE patchmill_core)
endforeach()

foreach(GROUP SpindleLocked Prediction ConstantFeed Calibration Harness LoadOrFault)
  add_test(NAME controller.synchronisation.${GROUP}
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/synchronisation_test.py ${GROUP})
  set_tests_properties(controller.synchronisation.${GROUP} PROPERTIES LABELS controller RUN_SERIAL ON TIMEOUT 900 SKIP_RETURN_CODE 77
                       ENVIRONMENT "MAKE_PROGRAM=$<TARGET_FILE:make_program>")
endforeach()

foreach(GROUP TipInWork FormsAgree PhaseWithCTurning)
  add_test(NAME controller.five_axis.${GROUP}
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/five_axis_test.py ${GROUP})
  set_tests_properties(controller.five_axis.${GROUP} PROPERTIES LABELS controller RUN_SERIAL ON TIMEOUT 900 SKIP_RETURN_CODE 77
                       ENVIRONMENT "MAKE_FIVE_AXIS=$<TARGET_FILE:make_five_axis>")
endforeach()
