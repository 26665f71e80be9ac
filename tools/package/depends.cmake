# CPack reads this file before it packs a build for another architecture.
execute_process(COMMAND ${CPACK_RAYMARCH_DEPENDS} OUTPUT_VARIABLE libraries
  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
string(APPEND CPACK_DEBIAN_SERVICE_PACKAGE_DEPENDS ", ${libraries}")
