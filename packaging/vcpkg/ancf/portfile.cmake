# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# An overlay port: vcpkg install ancf --overlay-ports=packaging/vcpkg. It takes the sources that it stands in.

set(VCPKG_BUILD_TYPE release) # headers alone
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

vcpkg_cmake_configure(
    SOURCE_PATH "${SOURCE_PATH}"
    OPTIONS
        -DANCF_INSTALL=ON
        -DANCF_BUILD_TESTS=OFF
        -DANCF_BUILD_EXAMPLES=OFF
        -DANCF_BUILD_BENCH=OFF
        -DANCF_WITH_SUITESPARSE=OFF
        -DANCF_WITH_SUNDIALS=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME ancf CONFIG_PATH share/cmake/ancf)

file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/lib")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
