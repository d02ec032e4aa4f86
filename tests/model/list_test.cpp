// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Lists: what they share with std::vector, and what may go wrong in memory of one's own.

#include <ancf/list.hpp>

#include <support/catch.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace list_test {

using ancf::List;

/// Counts its objects, and throws where the copy numbered `fatal` is made.
struct Counted {
    static inline int alive = 0, copies = 0, fatal = -1;

    explicit Counted(int told = 0) : value(told) { ++alive; }
    Counted(const Counted& other) : value(other.value) {
        if (++copies == fatal) throw std::runtime_error("no copy");
        ++alive;
    }
    Counted(Counted&& other) noexcept : value(std::exchange(other.value, -1)) { ++alive; }
    Counted& operator=(const Counted&) = default;
    Counted& operator=(Counted&&) = default;
    ~Counted() { --alive; }

    int value;
};

struct alignas(64) Aligned {
    double value;
};

TEST_CASE("a list grows like a std::vector, of plain data and of texts") {
    List<int> numbers;
    List<std::string> texts;
    std::vector<int> same_numbers;
    std::vector<std::string> same_texts;
    for (int k = 0; k < 1000; ++k) {
        numbers.push_back(k);
        same_numbers.push_back(k);
        texts.emplace_back(std::size_t(k % 40), 'x');
        same_texts.emplace_back(std::size_t(k % 40), 'x');
    }
    CHECK(numbers == same_numbers);
    CHECK(texts == same_texts);
    CHECK(numbers != std::vector<int>{});
    CHECK(std::vector<std::string>(texts) == same_texts);
    CHECK(numbers.size() == 1000);
    CHECK(numbers.front() == 0);
    CHECK(numbers.back() == 999);
    CHECK(numbers.at(999) == 999);
    CHECK_THROWS_AS(numbers.at(1000), std::out_of_range);
}

TEST_CASE("a list takes an item of its own while it grows") {
    List<std::string> texts(1, std::string(50, 'a'));
    for (int k = 0; k < 10; ++k) texts.push_back(texts[0]);
    texts.resize(40, texts[0]);
    texts.assign(100, texts[0]);
    for (const std::string& text : texts) CHECK(text == std::string(50, 'a'));
    CHECK(texts.size() == 100);
}

TEST_CASE("items are inserted and removed in place") {
    const List<std::string> extra = {"x", "y"};
    for (const std::size_t at : {0, 1, 3}) {
        List<std::string> texts = {"a", "b", "c"};
        std::vector<std::string> same(texts);
        std::string* const place = texts.insert(texts.begin() + at, extra.begin(), extra.end());
        same.insert(same.begin() + std::ptrdiff_t(at), {"x", "y"});
        CHECK(place == texts.begin() + at);
        CHECK(texts == same);
        CHECK(texts.erase(place, place + 2) == texts.begin() + at);
        CHECK(texts == List<std::string>{"a", "b", "c"});
        texts.erase(texts.begin() + 1);
        texts.pop_back();
        CHECK(texts == List<std::string>{"a"});
    }
}

/// Has no move constructor: growing copies it, and may throw.
struct Copied : Counted {
    explicit Copied(int told = 0) : Counted(told) {}
    Copied(const Copied& other) : Counted(other) {}
    Copied& operator=(const Copied&) = default;
};

TEST_CASE("other iterators, single items and rows of them do as with std::vector") {
    const std::vector<int> more = {7, 8};
    List<int> numbers(more.begin(), more.end());
    numbers.insert(numbers.begin(), {1, 2});
    numbers.insert(numbers.begin() + 1, numbers[3]);
    numbers.insert(numbers.end(), more.rbegin(), more.rend());
    CHECK(numbers == std::vector<int>{1, 8, 2, 7, 8, 8, 7});
    CHECK(std::vector<int>(numbers.rbegin(), numbers.rend()) ==
          std::vector<int>{7, 8, 8, 7, 2, 8, 1});
    numbers.assign(more.begin(), more.end());
    CHECK(numbers == more);
    numbers.assign({3});
    CHECK(numbers == List<int>{3});
    List<std::string> texts = {"a", "b"};
    texts.erase(texts.begin(), texts.begin());
    CHECK(texts == List<std::string>{"a", "b"});
}

TEST_CASE("items of a derived class are taken one by one") {
    struct Base {
        int value;
    };
    struct Derived : Base {
        double more;
    };
    const List<Derived> derived = {{{1}, 0.1}, {{2}, 0.2}, {{3}, 0.3}};
    List<Base> items(derived.begin(), derived.end());
    items.insert(items.begin() + 1, derived.begin(), derived.end());
    List<Base> assigned;
    assigned.assign(derived.begin(), derived.end());
    items.insert(items.end(), assigned.begin(), assigned.end());
    std::vector<int> values;
    for (const Base& item : items) values.push_back(item.value);
    CHECK(values == std::vector<int>{1, 1, 2, 3, 2, 3, 1, 2, 3});
}

TEST_CASE("a list that was moved from is empty") {
    List<std::string> from = {"a", "b"}, to = {"c"};
    to = std::move(from);
    CHECK(to == List<std::string>{"a", "b"});
    CHECK(from.empty());  // NOLINT: told so
    List<std::string>& self = to;
    to = self;
    CHECK(to.size() == 2);
    List<int> plain = {1, 2}, other(std::move(plain));
    CHECK(plain.empty());  // NOLINT: told so
    CHECK(other == List<int>{1, 2});
}

TEST_CASE("items keep their alignment") {
    List<Aligned> items;
    for (int k = 0; k < 20; ++k) {
        items.push_back({1.0 * k});
        REQUIRE(reinterpret_cast<std::uintptr_t>(items.data()) % 64 == 0);
    }
    const List<Aligned> copied = items;
    CHECK(reinterpret_cast<std::uintptr_t>(copied.data()) % 64 == 0);
    CHECK(copied[19].value == 19.0);
}

TEST_CASE("no item is left or lost where a copy throws") {
    const int before = Counted::alive;
    {
        List<Counted> items;
        for (int k = 0; k < 5; ++k) items.emplace_back(k);
        for (int fatal = 1; fatal <= 5; ++fatal) {
            Counted::copies = 0;
            Counted::fatal = fatal;
            List<Counted> target(3);
            CHECK_THROWS_AS(List<Counted>(items), std::runtime_error);
            Counted::copies = 0;
            CHECK_THROWS_AS(target = items, std::runtime_error);
            CHECK(target.size() == 3);
            CHECK(Counted::alive == before + 8);
        }
        Counted::fatal = -1;
        {
            List<Copied> copied(4);
            Counted::copies = 0;
            Counted::fatal = 3;
            CHECK_THROWS_AS(copied.reserve(100), std::runtime_error);
            Counted::fatal = -1;
            CHECK(copied.size() == 4);
            CHECK(Counted::alive == before + 9);
        }
        items.resize(2);
        CHECK(Counted::alive == before + 2);
        CHECK(items[1].value == 1);
    }
    CHECK(Counted::alive == before);
}

TEST_CASE("a list of too many items throws, whatever their size multiplies to") {
    const std::size_t most = std::numeric_limits<std::size_t>::max();
    List<double> numbers = {1.0};
    for (const std::size_t count : {most, most / 8 + 2, most / 16 + 1})
        CHECK_THROWS_AS(numbers.resize(count), std::bad_alloc);
    CHECK_THROWS_AS(List<std::string>(most), std::bad_alloc);
    CHECK(numbers == List<double>{1.0});
}

}  // namespace list_test
