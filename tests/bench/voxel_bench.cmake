# OpenVDB is the peer of voxel_bench where it is installed.
find_library(OPENVDB_LIBRARY openvdb)
find_library(IMATH_LIBRARY NAMES Imath Imath-3_1)
if(OPENVDB_LIBRARY)
  target_compile_definitions(voxel_bench PRIVATE PATCHMILL_HAVE_OPENVDB)
  target_link_libraries(voxel_bench PRIVATE ${OPENVDB_LIBRARY} ${IMATH_LIBRARY})
  target_compile_options(voxel_bench PRIVATE -Wno-error)
endif()
