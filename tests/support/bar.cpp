// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <support/bar.hpp>

#include <ancf/model/group_of.hpp>

#include <memory>

template std::unique_ptr<ancf::ElementGroup> ancf::detail::make_group<ancf::test::Bar<2>>();
template std::unique_ptr<ancf::ElementGroup> ancf::detail::make_group<ancf::test::Bar<3>>();
