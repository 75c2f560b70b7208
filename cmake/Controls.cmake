# The registry of controls: each NAME.cpp of a folder defines the function `const Control& NAME()`. Adding a control
# is adding its file.
# SPDX-License-Identifier: LGPL-2.1-or-later
function(write_control_registry FOLDER HEADER OUTPUT)
  file(GLOB FILES CONFIGURE_DEPENDS ${FOLDER}/*.cpp)
  list(SORT FILES)
  set(DECLARED "")
  set(LISTED "")
  foreach(FILE ${FILES})
    get_filename_component(NAME ${FILE} NAME_WE)
    string(APPEND DECLARED "const Control& ${NAME}();\n")
    string(APPEND LISTED "&${NAME}(), ")
  endforeach()
  file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT
"// Made by cmake/Controls.cmake from the files of ${FOLDER}.
#include \"${HEADER}\"

namespace patchmill::gcode {
${DECLARED}
const std::vector<const Control*>& controls() {
  static const std::vector<const Control*> all = {${LISTED}};
  return all;
}

}  // namespace patchmill::gcode
")
endfunction()
