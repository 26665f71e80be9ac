# Cross build for the board (Cortex-A9, hard float) with Debian's compiler and an extracted sysroot.
# RAYMARCH_ARMHF_SYSROOT (environment or cache) names the sysroot; ./dev armhf makes it.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR armv7l)

if(NOT RAYMARCH_ARMHF_SYSROOT)
  set(RAYMARCH_ARMHF_SYSROOT "$ENV{RAYMARCH_ARMHF_SYSROOT}" CACHE PATH "armhf sysroot")
endif()
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES RAYMARCH_ARMHF_SYSROOT)
set(CMAKE_SYSROOT "${RAYMARCH_ARMHF_SYSROOT}")

set(CMAKE_C_COMPILER arm-linux-gnueabihf-gcc)
set(CMAKE_CXX_COMPILER arm-linux-gnueabihf-g++)
set(CMAKE_CXX_FLAGS_INIT "-mcpu=cortex-a9 -mfpu=neon -mfloat-abi=hard -D_FILE_OFFSET_BITS=64")

set(CMAKE_FIND_ROOT_PATH "${CMAKE_SYSROOT}")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_SYSROOT_DIR} "${CMAKE_SYSROOT}")
set(ENV{PKG_CONFIG_LIBDIR}
    "${CMAKE_SYSROOT}/usr/lib/arm-linux-gnueabihf/pkgconfig:${CMAKE_SYSROOT}/usr/share/pkgconfig")

find_program(RAYMARCH_QEMU_ARM qemu-arm-static)
if(RAYMARCH_QEMU_ARM)
  set(CMAKE_CROSSCOMPILING_EMULATOR "${RAYMARCH_QEMU_ARM};-L;${CMAKE_SYSROOT}")
endif()
