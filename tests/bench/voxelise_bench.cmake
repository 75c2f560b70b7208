# The peer is OpenCASCADE's.
target_link_libraries(voxelise_bench PRIVATE TKBO TKBool TKPrim)
