# cpack runs this between the installation of a component and its packing. It adds the files that Debian requires in a
# package, and makes the package reproducible (SOURCE_DATE_EPOCH).

set(here ${CPACK_TWRENCH_FOLDER}/packaging)

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Like dh_strip.
function(strip_debris root)
  set(debris --remove-section=.comment --remove-section=.note)
  file(GLOB programs ${root}/usr/bin/*)
  file(GLOB_RECURSE modules ${root}/usr/lib/*.so)
  foreach(file IN LISTS programs)
    run(${CPACK_TWRENCH_STRIP} ${debris} ${file})
  endforeach()
  foreach(file IN LISTS modules)
    run(${CPACK_TWRENCH_STRIP} --strip-unneeded ${debris} ${file})
  endforeach()
  file(GLOB_RECURSE archives ${root}/usr/lib/*.a)
  foreach(file IN LISTS archives)
    run(${CPACK_TWRENCH_STRIP} --strip-debug --enable-deterministic-archives ${debris} ${file})
  endforeach()
endfunction()

function(add_documents root package)
  set(doc ${root}/usr/share/doc/${package})
  file(MAKE_DIRECTORY ${doc})
  file(COPY ${here}/copyright DESTINATION ${doc})
  file(COPY_FILE ${CPACK_TWRENCH_FOLDER}/CHANGELOG.md ${doc}/changelog)
  string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
  configure_file(${here}/changelog.Debian.in ${doc}/changelog.Debian @ONLY)
  file(GLOB_RECURSE pages ${root}/usr/share/man/*.[1-9])
  run(gzip -9n ${doc}/changelog ${doc}/changelog.Debian ${pages})
  file(MAKE_DIRECTORY ${root}/usr/share/lintian/overrides)
  file(COPY_FILE ${here}/lintian-overrides ${root}/usr/share/lintian/overrides/${package})
endfunction()

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} upper)
  set(root ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${component})
  strip_debris(${root})
  add_documents(${root} ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  # Independent of the umask and of the modes in the checkout.
  run(chmod -R u=rwX,go=rX ${root})
endforeach()
string(TIMESTAMP epoch "%s" UTC)
run(find ${CPACK_TEMPORARY_INSTALL_DIRECTORY} -exec touch --no-dereference --date=@${epoch} "{}" +)
