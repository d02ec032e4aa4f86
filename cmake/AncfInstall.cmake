# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Headers, CMake package, pkg-config file, Debian package: nothing of them depends on the architecture. With
# ANCF_INSTALL_COMPILED the compiled library as well, with a CMake package, a pkg-config file and a Debian package of its own.

include(CMakePackageConfigHelpers)

set(ANCF_INSTALL_CMAKEDIR ${CMAKE_INSTALL_DATADIR}/cmake/ancf)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ancf DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    FILES_MATCHING PATTERN "*.hpp" PATTERN "*.ipp")
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(TARGETS ancf EXPORT ancfTargets)
install(TARGETS ancf_suitesparse EXPORT ancfSuitesparseTargets)
install(TARGETS ancf_sundials EXPORT ancfSundialsTargets)
install(TARGETS ancf_petsc EXPORT ancfPetscTargets)
foreach(export ancfTargets ancfSuitesparseTargets ancfSundialsTargets ancfPetscTargets)
    install(EXPORT ${export} NAMESPACE ancf:: DESTINATION ${ANCF_INSTALL_CMAKEDIR})
endforeach()

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/ancfConfig.cmake.in
    ${PROJECT_BINARY_DIR}/cmake/ancfConfig.cmake INSTALL_DESTINATION ${ANCF_INSTALL_CMAKEDIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cmake/ancfConfigVersion.cmake
    COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES
    ${PROJECT_BINARY_DIR}/cmake/ancfConfig.cmake
    ${PROJECT_BINARY_DIR}/cmake/ancfConfigVersion.cmake
    ${PROJECT_SOURCE_DIR}/cmake/AncfDependencies.cmake
    ${PROJECT_SOURCE_DIR}/cmake/FindSuiteSparse.cmake
    DESTINATION ${ANCF_INSTALL_CMAKEDIR})

# The prefix is found from the file's own place, so that an installed tree can be moved. Folders may be absolute.
file(RELATIVE_PATH ANCF_PC_TO_PREFIX "${CMAKE_INSTALL_FULL_DATADIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
string(REGEX REPLACE "/$" "" ANCF_PC_TO_PREFIX "${ANCF_PC_TO_PREFIX}")
cmake_path(APPEND ANCF_PC_INCLUDEDIR "\${prefix}" "${CMAKE_INSTALL_INCLUDEDIR}")
configure_file(${PROJECT_SOURCE_DIR}/cmake/ancf.pc.in ${PROJECT_BINARY_DIR}/cmake/ancf.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/cmake/ancf.pc DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig)

if(ANCF_INSTALL_COMPILED)
    set(ANCF_INSTALL_COMPILED_CMAKEDIR ${CMAKE_INSTALL_LIBDIR}/cmake/ancf_compiled)
    set(libraries ancf_compiled)
    install(TARGETS ancf_compiled EXPORT ancfCompiledTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT compiled)
    install(EXPORT ancfCompiledTargets NAMESPACE ancf:: DESTINATION ${ANCF_INSTALL_COMPILED_CMAKEDIR}
        COMPONENT compiled)
    foreach(component suitesparse sundials petsc)
        if(TARGET ancf_compiled_${component})
            list(APPEND libraries ancf_compiled_${component})
            install(TARGETS ancf_compiled_${component} EXPORT ancfCompiled_${component}Targets
                ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT compiled)
            install(EXPORT ancfCompiled_${component}Targets NAMESPACE ancf::
                DESTINATION ${ANCF_INSTALL_COMPILED_CMAKEDIR} COMPONENT compiled)
        endif()
    endforeach()
    set_target_properties(${libraries} PROPERTIES EXCLUDE_FROM_ALL OFF)
    configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/ancf_compiledConfig.cmake.in
        ${PROJECT_BINARY_DIR}/cmake/ancf_compiledConfig.cmake
        INSTALL_DESTINATION ${ANCF_INSTALL_COMPILED_CMAKEDIR})
    write_basic_package_version_file(${PROJECT_BINARY_DIR}/cmake/ancf_compiledConfigVersion.cmake
        COMPATIBILITY ExactVersion)
    install(FILES
        ${PROJECT_BINARY_DIR}/cmake/ancf_compiledConfig.cmake
        ${PROJECT_BINARY_DIR}/cmake/ancf_compiledConfigVersion.cmake
        DESTINATION ${ANCF_INSTALL_COMPILED_CMAKEDIR} COMPONENT compiled)
    set(ANCF_COMPILED_PC_FLAGS)
    if(ANCF_COMPILED_OPENMP)
        set(ANCF_COMPILED_PC_FLAGS " ${OpenMP_CXX_FLAGS}")
    endif()
    file(RELATIVE_PATH ANCF_COMPILED_PC_TO_PREFIX "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
    string(REGEX REPLACE "/$" "" ANCF_COMPILED_PC_TO_PREFIX "${ANCF_COMPILED_PC_TO_PREFIX}")
    cmake_path(APPEND ANCF_COMPILED_PC_LIBDIR "\${prefix}" "${CMAKE_INSTALL_LIBDIR}")
    configure_file(${PROJECT_SOURCE_DIR}/cmake/ancf-compiled.pc.in ${PROJECT_BINARY_DIR}/cmake/ancf-compiled.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/cmake/ancf-compiled.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
        COMPONENT compiled)
endif()

if(PROJECT_IS_TOP_LEVEL)
    set(CPACK_GENERATOR DEB)
    set(CPACK_PACKAGE_NAME libancf-dev)
    set(CPACK_PACKAGE_VENDOR "The ancf authors")
    set(CPACK_PACKAGE_CONTACT "The ancf authors <${PROJECT_NAME}@localhost>")
    set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
    set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
    set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
    set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
    set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
    # the headers: one package for every machine; CMake calls what has no component Unspecified
    set(CPACK_DEB_COMPONENT_INSTALL ON)
    set(CPACK_COMPONENTS_ALL Unspecified)
    set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME libancf-dev)
    set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_ARCHITECTURE all)
    set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4)")
    set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_RECOMMENDS "libsuitesparse-dev, libsundials-dev")
    if(ANCF_INSTALL_COMPILED)
        list(APPEND CPACK_COMPONENTS_ALL compiled)
        set(CPACK_DEBIAN_COMPILED_PACKAGE_NAME libancf-compiled-dev)
        set(CPACK_DEBIAN_COMPILED_PACKAGE_DEPENDS "libancf-dev (= ${PROJECT_VERSION})")
    endif()
    include(CPack)
endif()
