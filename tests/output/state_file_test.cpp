// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/error.hpp>
#include <ancf/output/state_file.hpp>

#include <support/catch.hpp>
#include <support/grouped.hpp>
#include <support/random_state.hpp>

#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>
#include <string>

namespace state_file_test {

using ancf::SavedState;
using ancf::VectorX;

SavedState awkward() {
    SavedState saved;
    ancf::test::Random random(11);
    saved.state.time = 0.1 + 0.2;
    saved.state.q.resize(200);
    saved.state.v.resize(200);
    for (Eigen::Index k = 0; k < 200; ++k) {
        saved.state.q[k] =
            random.uniform(-1.0, 1.0) * std::pow(10.0, random.uniform(-300.0, 300.0));
        saved.state.v[k] = random.uniform(-1.0, 1.0);
    }
    saved.state.v[0] = -0.0;
    saved.state.v[1] = std::numeric_limits<double>::denorm_min();
    saved.state.v[2] = std::numeric_limits<double>::max();
    saved.state.multipliers = VectorX::Constant(1, 1.0 / 3.0);
    saved.memory.integrator = "some-method";
    saved.memory.put("acceleration", saved.state.v.head(7));
    saved.memory.put("nothing", VectorX());
    return saved;
}

std::string text(const SavedState& saved) {
    std::ostringstream out;
    ancf::write_state(out, saved);
    return out.str();
}

SavedState read(const std::string& from) {
    std::istringstream in(from);
    return ancf::read_state(in);
}

bool same_bits(const VectorX& a, const VectorX& b) {
    if (a.size() != b.size()) return false;
    for (Eigen::Index k = 0; k < a.size(); ++k)
        if (a[k] != b[k] || std::signbit(a[k]) != std::signbit(b[k])) return false;
    return true;
}

TEST_CASE("state file: every bit comes back", "[output][state-file]") {
    const SavedState saved = awkward();
    const SavedState back = read(text(saved));
    CHECK(back.state.time == saved.state.time);
    CHECK(same_bits(back.state.q, saved.state.q));
    CHECK(same_bits(back.state.v, saved.state.v));
    CHECK(same_bits(back.state.multipliers, saved.state.multipliers));
    CHECK(back.memory.integrator == "some-method");
    REQUIRE(back.memory.values.size() == 2);
    CHECK(same_bits(back.memory.get("acceleration", 7), saved.memory.get("acceleration", 7)));
    CHECK(back.memory.get("nothing", 0).size() == 0);
}

TEST_CASE("state file: the stream's locale changes nothing", "[output][state-file]") {
    std::ostringstream out;
    out.imbue(ancf::test::grouped());
    ancf::write_state(out, awkward());
    CHECK(out.str() == text(awkward()));
}

TEST_CASE("state file: files on disk", "[output][state-file]") {
    const auto file = std::filesystem::temp_directory_path() / "ancf-state-file-test.txt";
    SavedState saved = awkward();
    saved.memory = {};
    ancf::save_state(file, saved);
    const SavedState back = ancf::load_state(file);
    CHECK(same_bits(back.state.q, saved.state.q));
    CHECK(back.memory.empty());
    std::filesystem::remove(file);
    CHECK_THROWS_WITH(ancf::load_state(file), ContainsSubstring("cannot read"));
    CHECK_THROWS_WITH(ancf::save_state(file / "below", saved), ContainsSubstring("cannot write"));
}

TEST_CASE("state file: a link stays a link, and what is no file stays what it is",
          "[output][state-file]") {
    const auto folder = std::filesystem::temp_directory_path() / "ancf-state-file-link-test";
    std::filesystem::create_directories(folder);
    const auto file = folder / "file", link = folder / "link";
    SavedState saved = awkward();
    ancf::save_state(file, saved);
    std::filesystem::remove(link);
    std::filesystem::create_symlink(file, link);
    saved.state.time = 7.0;
    ancf::save_state(link, saved);
    CHECK(std::filesystem::is_symlink(link));
    CHECK(ancf::load_state(file).state.time == 7.0);
    CHECK_THROWS_WITH(ancf::save_state(folder, saved), ContainsSubstring("cannot write"));
    CHECK(std::filesystem::is_directory(folder));
    std::filesystem::remove_all(folder);
}

TEST_CASE("state file: every damaged line is refused by its number", "[output][state-file]") {
    SavedState saved;
    saved.state.q = VectorX::Constant(2, 1.5);
    saved.state.v = VectorX::Constant(2, 2.5);
    saved.memory.integrator = "some-method";
    saved.memory.put("a", VectorX::Constant(1, 3.5));
    const std::string good = text(saved);
    REQUIRE(read(good).state.q.size() == 2);
    int refused = 0;
    std::size_t start = 0;
    for (int line = 1; start < good.size(); ++line) {
        const std::size_t end = good.find('\n', start);
        for (const char* wrong : {"", "nonsense", "1.5x", "q -1", "nan"}) {
            const std::string bad = good.substr(0, start) + wrong + good.substr(end);
            CAPTURE(line, wrong);
            CHECK_THROWS_AS(read(bad), ancf::InvalidArgument);
            ++refused;
        }
        CAPTURE(line);
        CHECK_THROWS_WITH(read(good.substr(0, start)), ContainsSubstring("line"));  // cut off here
        start = end + 1;
    }
    CHECK(refused == 5 * 13);
    CHECK_THROWS_WITH(read("ancf-state 2\n"), ContainsSubstring("line 1"));
    CHECK_THROWS_WITH(read("ancf-state 1\ntime 0\nq 99999999\n1\n"), ContainsSubstring("line 5"));
}

TEST_CASE("state file: what cannot be read back is not written", "[output][state-file]") {
    SavedState saved = awkward();
    saved.state.q[3] = std::numeric_limits<double>::infinity();
    CHECK_THROWS_AS(text(saved), ancf::InvalidArgument);
    saved = awkward();
    saved.memory.integrator = "two words";
    CHECK_THROWS_AS(text(saved), ancf::InvalidArgument);
}

}  // namespace state_file_test
