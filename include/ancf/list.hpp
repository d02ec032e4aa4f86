// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Arrays that grow, cheap to compile; a user takes one for a std::vector, or copies it into one.
///
/// A std::vector of one more type costs a unit some seventy functions, a List fewer than twenty:
/// the memory of all of them is the work of one class that is no template.

#pragma once

#include <ancf/compiler.hpp>

#include <cstddef>
#include <initializer_list>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace ancf {

namespace detail {

/// The memory of a List, whatever it holds.
class ListStorage {
protected:
    ListStorage() noexcept = default;
    ListStorage(const ListStorage&) = delete;
    ListStorage& operator=(const ListStorage&) = delete;
    ~ListStorage() = default;

    /// Returns memory for `capacity` items of so many bytes.
    [[nodiscard]] static void* allocate(std::size_t capacity, std::size_t item,
                                        std::size_t alignment);
    static void release(void* data, std::size_t alignment) noexcept;
    /// Returns `count`, or twice the capacity where that is more.
    [[nodiscard]] std::size_t grown(std::size_t count) const noexcept {
        return count > 2 * capacity_ ? count : 2 * capacity_;
    }
    /// Makes room for `count` items, which a copy of their memory moves; sizes in bytes.
    void make_room(std::size_t count, std::size_t item, std::size_t alignment);
    /// Makes these items those of another list.
    void copy(const ListStorage& other, std::size_t item, std::size_t alignment);
    void swap(ListStorage& other) noexcept {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
    }

    /// Returns k. @throws std::out_of_range unless it is that of an item.
    [[nodiscard]] std::size_t within(std::size_t k) const;

    void* data_ = nullptr;
    std::size_t size_ = 0;      // items
    std::size_t capacity_ = 0;  // items
};

}  // namespace detail

/// An array that grows, with the members of std::vector that programs use, by the same names.
///
/// Pointers are its iterators. A std::vector becomes a List, and a List a std::vector, by a copy.
template <class T>
class List : private detail::ListStorage {
    // Chooses iterators that are no pointers to items; pointers to a derived class are none.
    template <class Iterator>
    using Other = std::enable_if_t<!std::is_same_v<const std::remove_pointer_t<Iterator>, const T>,
                                   typename std::iterator_traits<Iterator>::iterator_category*>;

public:
    /// @cond of what std::vector has by the same names
    using value_type = T;
    using iterator = T*;
    using const_iterator = const T*;

    List() noexcept = default;
    explicit List(std::size_t count) : List() { resize(count); }
    List(std::size_t count, const T& value) : List() { resize(count, value); }
    List(std::initializer_list<T> all) : List() { append(all.begin(), all.end()); }
    List(const T* first, const T* last) : List() { append(first, last); }
    template <class Iterator, Other<Iterator> = nullptr>
    List(Iterator first, Iterator last) : List() {
        for (; first != last; ++first) push_back(*first);
    }
    List(const std::vector<T>& all) : List() { append(all.data(), all.data() + all.size()); }
    List(const List& other) : List() {
        if constexpr (std::is_trivially_copyable_v<T>)
            copy(other, sizeof(T), alignof(T));
        else
            append(other.begin(), other.end());
    }
    List(List&& other) noexcept { detail::ListStorage::swap(other); }
    List& operator=(const List& other) {
        if (this == &other) return *this;
        if constexpr (std::is_trivially_copyable_v<T>) {
            copy(other, sizeof(T), alignof(T));
        } else {
            List copied(other);
            swap(copied);
        }
        return *this;
    }
    List& operator=(List&& other) noexcept {
        List taken(std::move(other));
        swap(taken);
        return *this;
    }
    ~List() {
        clear();
        release(data_, alignof(T));
    }
    operator std::vector<T>() const { return std::vector<T>(begin(), end()); }

    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
    [[nodiscard]] T* data() noexcept { return static_cast<T*>(data_); }
    [[nodiscard]] const T* data() const noexcept { return static_cast<const T*>(data_); }
    [[nodiscard]] T* begin() noexcept { return static_cast<T*>(data_); }
    [[nodiscard]] const T* begin() const noexcept { return static_cast<const T*>(data_); }
    [[nodiscard]] T* end() noexcept { return static_cast<T*>(data_) + size_; }
    [[nodiscard]] const T* end() const noexcept { return static_cast<const T*>(data_) + size_; }
    [[nodiscard]] const T* cbegin() const noexcept { return begin(); }
    [[nodiscard]] const T* cend() const noexcept { return end(); }
    [[nodiscard]] auto rbegin() noexcept { return std::reverse_iterator<T*>(end()); }
    [[nodiscard]] auto rbegin() const noexcept { return std::reverse_iterator<const T*>(end()); }
    [[nodiscard]] auto rend() noexcept { return std::reverse_iterator<T*>(begin()); }
    [[nodiscard]] auto rend() const noexcept { return std::reverse_iterator<const T*>(begin()); }
    [[nodiscard]] T& operator[](std::size_t k) noexcept { return static_cast<T*>(data_)[k]; }
    [[nodiscard]] const T& operator[](std::size_t k) const noexcept {
        return static_cast<const T*>(data_)[k];
    }
    [[nodiscard]] T& at(std::size_t k) { return data()[within(k)]; }
    [[nodiscard]] const T& at(std::size_t k) const { return data()[within(k)]; }
    [[nodiscard]] T& front() noexcept { return data()[0]; }
    [[nodiscard]] const T& front() const noexcept { return data()[0]; }
    [[nodiscard]] T& back() noexcept { return data()[size_ - 1]; }
    [[nodiscard]] const T& back() const noexcept { return data()[size_ - 1]; }

    void reserve(std::size_t count) {
        if (count > capacity_) grow(count);
    }
    T& push_back(T value) {
        if (size_ == capacity_) grow(size_ + 1);
        T* const added = ::new (static_cast<void*>(end())) T(std::move(value));
        ++size_;
        return *added;
    }
    template <class... Arguments>
    T& emplace_back(Arguments&&... arguments) {
        if constexpr (std::is_constructible_v<T, Arguments...>)
            return push_back(T(std::forward<Arguments>(arguments)...));
        else
            return push_back(T{std::forward<Arguments>(arguments)...});
    }
    void pop_back() noexcept { shorten(size_ - 1); }
    void clear() noexcept { shorten(0); }
    /// New items are T().
    void resize(std::size_t count) {
        shorten(count);
        reserve(count);
        for (; size_ < count; ++size_) ::new (static_cast<void*>(end())) T();
    }
    void resize(std::size_t count, T value) {
        shorten(count);
        reserve(count);
        while (size_ < count) push_back(value);
    }
    void assign(std::size_t count, T value) {
        clear();
        resize(count, std::move(value));
    }
    void assign(const T* first, const T* last) {
        clear();
        append(first, last);
    }
    template <class Iterator, Other<Iterator> = nullptr>
    void assign(Iterator first, Iterator last) {
        *this = List(first, last);
    }
    void assign(std::initializer_list<T> all) { assign(all.begin(), all.end()); }
    T* insert(const T* at, T value) { return insert(at, &value, &value + 1); }
    T* insert(const T* at, std::initializer_list<T> all) {
        return insert(at, all.begin(), all.end());
    }
    template <class Iterator, Other<Iterator> = nullptr>
    T* insert(const T* at, Iterator first, Iterator last) {
        const List all(first, last);
        return insert(at, all.begin(), all.end());
    }
    /// The items to insert must be none of this list.
    T* insert(const T* at, const T* first, const T* last) {
        const std::size_t before = static_cast<std::size_t>(at - begin());
        if (before == size_) {
            append(first, last);
        } else {
            List joined(begin(), at);
            joined.append(first, last);
            joined.append(at, end());
            swap(joined);
        }
        return begin() + before;
    }
    T* erase(const T* at) { return erase(at, at + 1); }
    T* erase(const T* first, const T* last) {
        T* const hole = begin() + (first - begin());
        if (first == last) return hole;
        T* to = hole;
        for (T* from = hole + (last - first); from != end();) *to++ = std::move(*from++);
        shorten(static_cast<std::size_t>(to - begin()));
        return hole;
    }
    void swap(List& other) noexcept { detail::ListStorage::swap(other); }

    friend bool operator==(const List& a, const List& b) {
        bool same = a.size_ == b.size_;
        for (std::size_t k = 0; same && k < a.size_; ++k) same = a.data()[k] == b.data()[k];
        return same;
    }
    friend bool operator!=(const List& a, const List& b) { return !(a == b); }
    /// @endcond

private:
    void append(const T* first, const T* last) {
        const std::size_t count = size_ + static_cast<std::size_t>(last - first);
        if (count > capacity_) grow(count);
        for (; first != last; ++first) push_back(*first);
    }
    void shorten(std::size_t count) noexcept {
        if constexpr (std::is_trivially_destructible_v<T>)
            size_ = count < size_ ? count : size_;
        else
            while (size_ > count) data()[--size_].~T();
    }
    // Makes room for so many items, for twice as many as there was room for at least.
    void grow(std::size_t count) {
        if constexpr (std::is_trivially_copyable_v<T>) {
            make_room(count, sizeof(T), alignof(T));
        } else {
            List larger;
            larger.capacity_ = grown(count);
            larger.data_ = allocate(larger.capacity_, sizeof(T), alignof(T));
            for (; larger.size_ < size_; ++larger.size_)
                ::new (static_cast<void*>(larger.end()))
                    T(std::move_if_noexcept(*(begin() + larger.size_)));
            swap(larger);
        }
    }
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/list.ipp>  // IWYU pragma: export
#endif
