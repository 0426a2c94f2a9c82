# Everything with coverage for libFuzzer and with sanitizers; an error ends the fuzzer.
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  message(FATAL_ERROR "MIXED_PALLETIZING_FUZZ needs clang++ (-DCMAKE_CXX_COMPILER=clang++), not ${CMAKE_CXX_COMPILER_ID}")
endif()
add_compile_options(-fsanitize=fuzzer-no-link,address,undefined
  -fsanitize-ignorelist=${CMAKE_CURRENT_LIST_DIR}/fuzz_ignored.txt -fno-sanitize-recover=all -UNDEBUG -D_GLIBCXX_ASSERTIONS -g1 -O2)
add_link_options(-fsanitize=address,undefined)
