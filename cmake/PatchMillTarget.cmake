# patchmill_target(NAME): C++17 and the warnings of every library and program of PatchMill. Set for each target by
# itself, so that a project which contains PatchMill, or links it, is compiled as it wants to be.
function(patchmill_target NAME)
  set_target_properties(${NAME} PROPERTIES CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF
                        POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden)
  target_compile_options(${NAME} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
  if(PATCHMILL_WERROR)
    target_compile_options(${NAME} PRIVATE -Werror)
  endif()
  # Same input, same bytes out: no fused multiply-add that one compiler makes and another does not.
  target_compile_options(${NAME} PRIVATE -ffp-contract=off)
  if(PATCHMILL_FUZZ)
    target_compile_options(${NAME} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
  if(PATCHMILL_SANITIZE)
    target_compile_options(${NAME} PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=all -O1 -g1)
    target_compile_definitions(${NAME} PRIVATE PATCHMILL_SANITIZE)
    target_link_options(${NAME} PUBLIC -fsanitize=address,undefined)
  endif()
endfunction()
