// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/error.hpp>
#include <ancf/section/material.hpp>

#include <support/catch.hpp>

#include <limits>
#include <string>

namespace material_test {

using ancf::InvalidArgument;
using ancf::Material;

TEST_CASE("Material: isotropic gives G = E/(2(1+nu)) and returns its Poisson's ratio",
          "[section][material]") {
    const double poisson = GENERATE(-0.9, -0.25, 0.0, 0.3, 0.4999, 0.5);
    const Material material = Material::isotropic(2.07e11, poisson, 7850.0);
    CHECK(material.young == 2.07e11);
    CHECK(material.density == 7850.0);
    CHECK(material.shear == Approx(2.07e11 / (2.0 * (1.0 + poisson))).epsilon(1e-15));
    CHECK(material.poisson() == Approx(poisson).margin(1e-15));
}

TEST_CASE("Material: two moduli are kept as given, whatever Poisson's ratio they amount to",
          "[section][material]") {
    const Material material = Material::from_moduli(1.0, 1.0, 2.0);
    CHECK(material.young == 1.0);
    CHECK(material.shear == 1.0);
    CHECK(material.density == 2.0);
    CHECK(material.poisson() == -0.5);
}

TEST_CASE("Material: a value that is not positive or not finite is refused by name",
          "[section][material]") {
    const double bad = GENERATE(0.0, -1.0, std::numeric_limits<double>::infinity(),
                                -std::numeric_limits<double>::infinity(),
                                std::numeric_limits<double>::quiet_NaN());
    CHECK_THROWS_WITH(Material::from_moduli(bad, 1.0, 1.0), ContainsSubstring("young"));
    CHECK_THROWS_WITH(Material::from_moduli(1.0, bad, 1.0), ContainsSubstring("shear"));
    CHECK_THROWS_WITH(Material::from_moduli(1.0, 1.0, bad), ContainsSubstring("density"));
    CHECK_THROWS_WITH(Material::isotropic(bad, 0.3, 1.0), ContainsSubstring("young"));
    CHECK_THROWS_WITH(Material::isotropic(1.0, 0.3, bad), ContainsSubstring("density"));
    CHECK_THROWS_AS((Material{1.0, bad, 1.0}.validate()), InvalidArgument);
}

TEST_CASE("Material: a Poisson's ratio outside (-1, 0.5] is refused and named",
          "[section][material]") {
    const double bad = GENERATE(-1.0, -2.0, 0.5000001, 1.0, std::numeric_limits<double>::infinity(),
                                std::numeric_limits<double>::quiet_NaN());
    CHECK_THROWS_WITH(Material::isotropic(1.0, bad, 1.0), ContainsSubstring("poisson"));
    CHECK_THROWS_AS(Material::isotropic(1.0, bad, 1.0), InvalidArgument);
}

}  // namespace material_test
