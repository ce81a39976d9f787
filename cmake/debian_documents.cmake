# Run by CPack on the staged packages: each gets its copyright and its change log. CPACK_WEFT_DOCUMENTED
# lists COMPONENT:PACKAGE; SOURCE_DATE_EPOCH, when set, makes the files the same every time.
cmake_policy(VERSION 3.25)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(entry "weft (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * See changelog.gz.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
foreach(pair IN LISTS CPACK_WEFT_DOCUMENTED)
  string(REPLACE ":" ";" pair ${pair})
  list(GET pair 0 component)
  list(GET pair 1 package)
  if(NOT component IN_LIST CPACK_COMPONENTS_ALL)
    continue()
  endif()
  set(folder ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr/share/doc/${package})
  file(MAKE_DIRECTORY ${folder})
  file(COPY_FILE ${CPACK_WEFT_SOURCE}/CHANGELOG.md ${folder}/changelog)
  file(WRITE ${folder}/changelog.Debian "${entry}")
  file(COPY_FILE ${CPACK_WEFT_SOURCE}/LICENSE ${folder}/copyright)
  file(CHMOD ${folder}/changelog ${folder}/changelog.Debian ${folder}/copyright
    PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
  execute_process(COMMAND gzip -9 --no-name --force ${folder}/changelog ${folder}/changelog.Debian
    COMMAND_ERROR_IS_FATAL ANY)
endforeach()
