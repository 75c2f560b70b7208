# Synchronisation that a real controller holds: programs made by the core, run through LinuxCNC.
add_executable(make_program ${CMAKE_CURRENT_LIST_DIR}/make_program.cpp
               ${CMAKE_CURRENT_LIST_DIR}/bezier.cpp)
target_link_libraries(make_program PRIVATE patchmill_core)
