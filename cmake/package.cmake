# Debian packages by CPack; ./dev package calls it. The service's package depends on no OpenCV: the
# modules that need it are a package of their own, where they are built.
set(package ${PROJECT_SOURCE_DIR}/tools/package)
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL service)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${package}/folders.cmake)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "ray-marching accelerator on Zynq: service, tool and models")
set(CPACK_PACKAGE_CONTACT "The raymarchd authors <raymarchd@packages.debian.org>")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION electronics)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_SERVICE_PACKAGE_NAME raymarchd)
set(CPACK_COMPONENT_SERVICE_DESCRIPTION
  "raymarchd takes frames of text from a serial port, turns them into register
words of a ray-marching accelerator in programmable logic, and answers each.
raymarchctl encodes, decodes, draws and speaks to the service.
Without a board both work on models that give the same bits.")
set(CPACK_DEBIAN_SERVICE_PACKAGE_CONTROL_EXTRA
  ${package}/service/conffiles ${package}/service/postinst ${package}/service/prerm
  ${package}/service/postrm)
set(CPACK_DEBIAN_SERVICE_PACKAGE_DEPENDS "systemd (>= 249), udev")
set(CPACK_DEBIAN_SERVICE_PACKAGE_SUGGESTS raymarchd-pictures)

set(CPACK_DEBIAN_PICTURES_PACKAGE_NAME raymarchd-pictures)
set(CPACK_DEBIAN_PICTURES_PACKAGE_DEPENDS "raymarchd (= ${PROJECT_VERSION})")
# Called when all targets are known: the module for MP4 is built only where videoio is installed.
macro(raymarch_describe_pictures)
  set(kinds "JPEG and GIF")
  set(films "MP4 is not in this build, which had no libopencv-videoio-dev.")
  if(TARGET raymarch_video)
    set(kinds "JPEG, GIF and MP4")
    set(films "")
  endif()
  string(JOIN "\n" CPACK_COMPONENT_PICTURES_DESCRIPTION
    "The modules that write ${kinds} for raymarchd and raymarchctl,"
    "with OpenCV. PNG, PPM and TGA need no module." ${films})
endmacro()

if(CMAKE_CROSSCOMPILING)
  # CPack's way has dpkg-shlibdeps look at what is installed here; depends.cmake has it look at the
  # sysroot.
  set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE armhf)
  set(CPACK_PROJECT_CONFIG_FILE ${package}/depends.cmake)
  set(CPACK_RAYMARCH_DEPENDS ${package}/depends.sh ${CMAKE_SYSROOT}
      ${PROJECT_BINARY_DIR}/raymarchd ${PROJECT_BINARY_DIR}/raymarchctl)
else()
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
endif()

# Debian wants these in every package, and pages of the manual compressed.
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(${package}/changelog.in ${PROJECT_BINARY_DIR}/changelog @ONLY)

# Installs FILE with gzip's ending, at the best compression and without a time of its own.
function(install_gzipped file destination component)
  get_filename_component(name ${file} NAME)
  set(zipped ${PROJECT_BINARY_DIR}/zipped/${component})
  install(CODE "
    file(MAKE_DIRECTORY ${zipped})
    execute_process(COMMAND gzip -9nc ${file} OUTPUT_FILE ${zipped}/${name}.gz
      COMMAND_ERROR_IS_FATAL ANY)" COMPONENT ${component})
  install(FILES ${zipped}/${name}.gz DESTINATION ${destination} COMPONENT ${component})
endfunction()

install(FILES ${package}/copyright DESTINATION share/doc/raymarchd COMPONENT service)
install_gzipped(${PROJECT_BINARY_DIR}/changelog share/doc/raymarchd service)
if(RAYMARCH_OPENCV)
  list(APPEND CPACK_COMPONENTS_ALL pictures)
  install(FILES ${package}/copyright DESTINATION share/doc/raymarchd-pictures COMPONENT pictures)
  install_gzipped(${PROJECT_BINARY_DIR}/changelog share/doc/raymarchd-pictures pictures)
endif()
