# Completes the trees of files that CPack is about to pack with what Debian asks of each package: the copyright, the
# changelog, and manual pages that are compressed. CPack runs it, with its own variables.

# CPack counts a date from the environment, where scripts/package sets that of the commit.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} key)
  set(package ${CPACK_DEBIAN_${key}_PACKAGE_NAME})
  set(tree ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr/share)
  set(changelog ${tree}/doc/${package}/changelog)
  file(MAKE_DIRECTORY ${tree}/doc/${package})
  file(COPY_FILE ${CPACK_BRECCIA_COPYRIGHT} ${tree}/doc/${package}/copyright)
  file(WRITE ${changelog} "breccia (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium

  * What has changed is told by /usr/share/doc/breccia/CHANGELOG.md.

 -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${date}
")
  file(GLOB manual_pages ${tree}/man/man?/*.?)
  execute_process(COMMAND gzip -9 -n ${changelog} ${manual_pages} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
