// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The least program of two units: for those that the linker has to refuse.

#include <ancf/model/model.hpp>

double height_of_tip(const ancf::Scene& model, ancf::NodeId tip);

int main() {
    ancf::Model model;
    return height_of_tip(model, model.add_node({0, 0, 0})) > 0.0 ? 1 : 0;
}
