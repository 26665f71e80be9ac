# Warnings, and the sanitizers of the preset: for every target of this tree. Warnings are errors where
# the preset says so, and not in a user's build, whose compiler may know more of them.
add_compile_options(-Wall -Wextra -Wpedantic -Wconversion -Wshadow)
if(RAYMARCH_WARNINGS_ARE_ERRORS)
  add_compile_options(-Werror)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Says only that a 32-bit ABI changed in gcc 7; nothing here crosses that border.
  add_compile_options(-Wno-psabi)
  # gcc 12 says it of an optional and an expected that hold nothing, where it inlines enough of them:
  # in the joined files of an optimised build. (Clang's tools, which read the flags of the dev preset,
  # do not know the option.)
  if(CMAKE_UNITY_BUILD)
    add_compile_options(-Wno-maybe-uninitialized)
  endif()
  # Designated initialisers name what differs from the defaults; the rest is meant.
  add_compile_options(-Wno-missing-field-initializers)
else()
  add_compile_options(-Wno-missing-field-initializers -Wno-missing-designated-field-initializers
                      -Wno-unknown-warning-option)
endif()
if(RAYMARCH_SANITIZE)
  add_compile_options(-fsanitize=${RAYMARCH_SANITIZE} -fno-omit-frame-pointer
                      -fno-sanitize-recover=all)
  # The sanitizers stand between a program and dlopen, which then does not look where the program's
  # RUNPATH says; the older RPATH holds for them too.
  add_link_options(-fsanitize=${RAYMARCH_SANITIZE} -Wl,--disable-new-dtags)
endif()
# A library that is linked and not used costs its start: Highway's, wherever nothing is asserted.
add_link_options(LINKER:--as-needed)
add_compile_definitions(RAYMARCH_VERSION="${PROJECT_VERSION}")
include_directories(${PROJECT_SOURCE_DIR})
