# A Debian package of what cmake/Install.cmake installs: `cpack --preset deb` (docs/packaging.md).
set(ASPERITY_MAINTAINER "Asperity maintainers <maintainers@asperity.invalid>" CACHE STRING "Maintainer named in the Debian package")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME asperity)
set(CPACK_PACKAGE_CONTACT "${ASPERITY_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
# Permissions do not depend on the umask of whoever packages.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS fonts-dejavu-core)  # text in pictures, read as a file
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "paraview, slurm-client")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"A JSON file describes a laboratory test of rock; on a machine without a
display Asperity simulates it with bonded triangular particles and leaves a
time series for ParaView, pictures of cracks and damage, curves, an energy
account and the record of where every number comes from. It calibrates
microparameters, and names what the calibrated model gets wrong in measured
tests.")

# Debian's own changelog; what changed stands in CHANGELOG.md.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
execute_process(COMMAND git -C ${PROJECT_SOURCE_DIR} log -1 --format=%cD OUTPUT_VARIABLE committed OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(committed)
  set(date "${committed}")
endif()
set(changelog ${PROJECT_BINARY_DIR}/changelog.Debian)
file(WRITE ${changelog} "asperity (${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) bookworm; urgency=medium

  * Made from the project's own build; see CHANGELOG.md.

 -- ${ASPERITY_MAINTAINER}  ${date}
")
execute_process(COMMAND gzip -9nf ${changelog} COMMAND_ERROR_IS_FATAL ANY)
install(FILES ${changelog}.gz DESTINATION share/doc/asperity)

include(CPack)
