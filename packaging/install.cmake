# `make install` and `make package`: one front command, bin/piae-dt, for programs whose names other packages have,
# too. The programs are in lib/piae-dt, what make reads in share/piae-dt, in folders as they are here.
#
# What only LibTorch computes is a component, and a package, of its own: its programs are found next to the others at
# run time, and LibTorch is 0.5 GB that few need.

install(PROGRAMS packaging/piae-dt DESTINATION bin COMPONENT programs)
foreach(program IN LISTS PROGRAMS)
  set(component programs)
  if(program MATCHES "-libtorch$")
    set(component libtorch)
  endif()
  install(TARGETS ${program} RUNTIME DESTINATION lib/piae-dt COMPONENT ${component})
endforeach()

# Installs files of these sources below a folder, in folders as they are here.
function(install_as_here destination)
  foreach(file IN LISTS ARGN)
    get_filename_component(folder ${file} DIRECTORY)
    install(FILES ${file} DESTINATION ${destination}/${folder} COMPONENT programs)
  endforeach()
endfunction()

# Of pipeline/ not what builds and checks; of the reference the numbers, for `make check`, without their pictures.
set(home share/piae-dt)
install(DIRECTORY pipeline jobs DESTINATION ${home} COMPONENT programs USE_SOURCE_PERMISSIONS
        PATTERN pipeline/lint EXCLUDE
        REGEX "pipeline/(lint|build|deps|keep_shown|sums|reference_all)\\.sh$" EXCLUDE)
file(GLOB_RECURSE numbers RELATIVE ${PROJECT_SOURCE_DIR} results/published/* results/reference/*.csv
     results/reference/*.h5)
list(FILTER numbers EXCLUDE REGEX "/(figures|readings)/")
install_as_here(${home} Makefile ${numbers})

# The pages, and what they link to: the evidence, and settings.
file(GLOB pages RELATIVE ${PROJECT_SOURCE_DIR} *.md CITATION.cff docs/* results/*.md jobs/*.md pipeline/datasets/*.md
     pipeline/protocol.toml pipeline/bearings.csv pipeline/reference_all.sh jobs/costs.csv results/published/*
     results/reference/before/uestc-true-types-zero.csv)
file(GLOB_RECURSE evidence RELATIVE ${PROJECT_SOURCE_DIR} results/reference/*.md results/reference/*.svg)
install_as_here(share/doc/piae-dt ${pages} ${evidence})
file(READ LICENSE license)
file(READ packaging/third_party.txt third_party)
file(WRITE ${PROJECT_BINARY_DIR}/copyright "${license}\n\n${third_party}")
install(FILES LICENSE ${PROJECT_BINARY_DIR}/copyright DESTINATION share/doc/piae-dt COMPONENT programs)
install(FILES ${PROJECT_BINARY_DIR}/copyright DESTINATION share/doc/piae-dt-libtorch COMPONENT libtorch
        EXCLUDE_FROM_ALL)
# The pages are of the day of the commit, so that the same sources give the same bytes.
name_day(${PROJECT_SOURCE_DIR} day)
install(CODE "execute_process(COMMAND \"${PROJECT_SOURCE_DIR}/packaging/man.sh\" \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}\" ${day}
                              COMMAND_ERROR_IS_FATAL ANY)" COMPONENT programs)

# ---- Debian packages ----------------------------------------------------------------------------
# A package is for the release it was built on, whose name is part of its version.
set(release 1)
if(EXISTS /etc/os-release)
  file(STRINGS /etc/os-release id REGEX "^ID=")
  file(STRINGS /etc/os-release number REGEX "^VERSION_ID=")
  string(REGEX REPLACE "VERSION_ID=|ID=|[^a-z0-9.]" "" release "${id}${number}")
  set(release "1~${release}")
endif()
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ${PROJECT_NAME})
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "The PIAE-DT pipeline authors")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)  # a fifth of gzip's size: the programs have much in common
set(CPACK_DEBIAN_PACKAGE_RELEASE ${release})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL programs)
if(PIAE_LIBTORCH)
  list(APPEND CPACK_COMPONENTS_ALL libtorch)
endif()
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME piae-dt)
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION "bearing fault data from a digital twin, as a batch pipeline
Makes the fault windows that a bearing in service does not yield, by the
method PIAE-DT and by others, trains and tests classifiers with them, and
compares the methods over data sets, ratios and seeds in tables, figures
and a report.")
# make runs the grid; it draws by gnuplot and fetches recordings by curl.
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_DEPENDS "make (>= 4.3)")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS "gnuplot-nox, qpdf, fonts-dejavu-core, curl, ca-certificates")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SUGGESTS "piae-dt-libtorch")
set(CPACK_DEBIAN_LIBTORCH_PACKAGE_NAME piae-dt-libtorch)
set(CPACK_DEBIAN_LIBTORCH_DESCRIPTION "networks of piae-dt by LibTorch
The programs of piae-dt once more, linked with LibTorch: for
--backend libtorch and --device cuda.")
set(CPACK_DEBIAN_LIBTORCH_PACKAGE_DEPENDS "piae-dt (= ${PROJECT_VERSION}-${release})")
include(CPack)
