// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A shared library that hides its symbols and looks at a model of its caller's.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/model.hpp>

__attribute__((visibility("default"))) int beams_in(const ancf::Model& model) {
    return model.group<ancf::CrossSectionBeam<3>>().size();
}

__attribute__((visibility("default"))) void refuse_node(const ancf::Model& model) {
    static_cast<void>(model.position(ancf::NodeId{77}));
}
