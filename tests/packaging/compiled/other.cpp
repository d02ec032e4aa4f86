// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/model/model.hpp>

double height_of_tip(const ancf::Scene& model, ancf::NodeId tip) {
    return model.state().q[model.coordinate(tip, ancf::Field::r) + 1];
}
