// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <one_step/rows.hpp>

#include <vector>

namespace ancf::bench::one_step {

std::vector<Row> other_rows() {
    std::vector<Row> rows;
    add_elastica<TorsionBeam>(rows);
    add_bends<TorsionBeam>(rows);
    add_circle<TorsionBeam>(rows);
    add_frame<TorsionBeam>(rows);
    add_elastica<Continuum>(rows);
    add_circle<Continuum>(rows);
    add_frame<Continuum>(rows);
    add_elastica<Cable>(rows);
    return rows;
}

}  // namespace ancf::bench::one_step
