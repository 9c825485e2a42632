# Eigen and Spectra, from the system. They are reached through a folder of two links, so that a cross-compiler sees
# these two and none of the system's other headers.

# Named outright, because a cross-compiler's CMake searches its own system only.
set(host_includes PATHS /usr/include /usr/local/include NO_CMAKE_FIND_ROOT_PATH)
find_path(EIGEN_HEADERS Eigen/Core ${host_includes} PATH_SUFFIXES eigen3 REQUIRED)
find_path(SPECTRA_HEADERS Spectra/SymEigsSolver.h ${host_includes} REQUIRED)

set(header_links "${PROJECT_BINARY_DIR}/third_party/include")
file(MAKE_DIRECTORY "${header_links}")
foreach(library Eigen:${EIGEN_HEADERS}/Eigen Spectra:${SPECTRA_HEADERS}/Spectra)
  string(REGEX MATCH "^([A-Za-z]+):(.+)$" _ "${library}")
  file(CREATE_LINK "${CMAKE_MATCH_2}" "${header_links}/${CMAKE_MATCH_1}" SYMBOLIC)
endforeach()

add_library(header_libraries INTERFACE)
target_include_directories(header_libraries SYSTEM INTERFACE "${header_links}")
