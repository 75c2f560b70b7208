# Stages build/Mod/PatchMill, the tree that FreeCAD loads (freecadcmd -M build/Mod/PatchMill), and
# installs the same tree into Mod/PatchMill below the prefix. Python files are links in the staged tree,
# so an edit needs no build.
set(STAGE ${PROJECT_BINARY_DIR}/Mod/PatchMill)
set_target_properties(_patchmill PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${STAGE})

set(MODULE_FILES Init.py InitGui.py package.xml LICENSE README.md)
file(MAKE_DIRECTORY ${STAGE})
foreach(FILE ${MODULE_FILES})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${FILE} ${STAGE}/${FILE} SYMBOLIC)
endforeach()
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/src/patchmill ${STAGE}/patchmill SYMBOLIC)
# FreeCAD finds tests by the name of a module: freecadcmd -t TestPatchMill
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/src/TestPatchMill.py ${STAGE}/TestPatchMill.py SYMBOLIC)
# FreeCAD finds a post-processor by its name and "_post.py" on sys.path
file(GLOB POST_FILES RELATIVE ${PROJECT_SOURCE_DIR}/src/posts CONFIGURE_DEPENDS
     ${PROJECT_SOURCE_DIR}/src/posts/*_post.py)
foreach(FILE ${POST_FILES})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/src/posts/${FILE} ${STAGE}/${FILE} SYMBOLIC)
endforeach()
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/Gui/patchmill_gui ${STAGE}/patchmill_gui SYMBOLIC)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/Resources ${STAGE}/Resources SYMBOLIC)

install(TARGETS _patchmill DESTINATION Mod/PatchMill COMPONENT module)
install(FILES ${MODULE_FILES} DESTINATION Mod/PatchMill COMPONENT module)
install(FILES src/TestPatchMill.py DESTINATION Mod/PatchMill COMPONENT module)
install(DIRECTORY src/posts/ DESTINATION Mod/PatchMill COMPONENT module FILES_MATCHING PATTERN "*_post.py")
install(DIRECTORY src/patchmill DESTINATION Mod/PatchMill COMPONENT module PATTERN __pycache__ EXCLUDE)
install(DIRECTORY Gui/patchmill_gui DESTINATION Mod/PatchMill COMPONENT module PATTERN __pycache__ EXCLUDE)
install(DIRECTORY src/stubs/_patchmill/ DESTINATION Mod/PatchMill/_patchmill-stubs COMPONENT module)
install(DIRECTORY Resources DESTINATION Mod/PatchMill COMPONENT module)
# the command `patchmill`
install(PROGRAMS tools/patchmill DESTINATION bin COMPONENT module)

# cmake --build build --target uninstall: what was installed last, and the folders that it leaves empty
add_custom_target(uninstall COMMAND ${CMAKE_COMMAND} -D MANIFEST=${CMAKE_BINARY_DIR}/install_manifest.txt
                                    -P ${CMAKE_SOURCE_DIR}/cmake/Uninstall.cmake)
