# Compile options of our own targets; link ${PROJECT_NAME}_warnings PRIVATE.
add_library(${PROJECT_NAME}_warnings INTERFACE)
target_compile_options(${PROJECT_NAME}_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
if(MIXED_PALLETIZING_WERROR)
  target_compile_options(${PROJECT_NAME}_warnings INTERFACE -Werror)
endif()
