// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Arrays of plain records, cheap to compile; a user reads them as a std::vector or copies them.
///
/// A std::vector of one more type costs a unit some seventy functions; a Records of one more type a
/// handful, as its storage is the same for all of them.

#pragma once

#include <ancf/compiler.hpp>

#include <cstddef>
#include <initializer_list>
#include <type_traits>
#include <utility>
#include <vector>

namespace ancf::detail {

/// The memory of a Records, whatever it holds.
class RecordStorage {
protected:
    explicit RecordStorage(std::size_t alignment) noexcept : alignment_(alignment) {}
    RecordStorage(const RecordStorage&) = delete;
    RecordStorage& operator=(const RecordStorage&) = delete;
    ~RecordStorage() { release(); }

    /// Makes room, at least twice what there was where that is not enough.
    /// @param record  bytes of a record
    void make_room(std::size_t records, std::size_t record);
    /// Copies the records of another one.
    void copy(const RecordStorage& other, std::size_t record);
    /// Exchanges the records with those of another one.
    void swap(RecordStorage& other) noexcept {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
    }

    void* data_ = nullptr;
    std::size_t size_ = 0;      // records
    std::size_t capacity_ = 0;  // records

private:
    void release() noexcept;

    std::size_t alignment_;
};

/// An array of trivially copyable records that grows: the members of std::vector that are used.
template <class T>
class Records : private RecordStorage {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    Records() noexcept : RecordStorage(alignof(T)) {}
    explicit Records(std::size_t count, const T& value = T()) : Records() { assign(count, value); }
    Records(std::initializer_list<T> all) : Records() {
        for (const T& one : all) push_back(one);
    }
    /// Copies a std::vector, which an interface takes.
    Records(const std::vector<T>& all) : Records() {
        reserve(all.size());
        for (const T& one : all) push_back(one);
    }
    Records(const Records& other) : Records() { copy(other, sizeof(T)); }
    Records(Records&& other) noexcept : Records() { RecordStorage::swap(other); }
    Records& operator=(const Records& other) {
        if (this != &other) copy(other, sizeof(T));
        return *this;
    }
    Records& operator=(Records&& other) noexcept {
        RecordStorage::swap(other);
        return *this;
    }
    ~Records() = default;

    /// Copies into a std::vector, which a caller may want.
    operator std::vector<T>() const { return {begin(), end()}; }

    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
    [[nodiscard]] T* data() noexcept { return static_cast<T*>(data_); }
    [[nodiscard]] const T* data() const noexcept { return static_cast<const T*>(data_); }
    [[nodiscard]] T* begin() noexcept { return data(); }
    [[nodiscard]] const T* begin() const noexcept { return data(); }
    [[nodiscard]] T* end() noexcept { return data() + size_; }
    [[nodiscard]] const T* end() const noexcept { return data() + size_; }
    [[nodiscard]] T& operator[](std::size_t k) noexcept { return data()[k]; }
    [[nodiscard]] const T& operator[](std::size_t k) const noexcept { return data()[k]; }
    [[nodiscard]] const T& front() const noexcept { return data()[0]; }
    [[nodiscard]] T& back() noexcept { return data()[size_ - 1]; }
    [[nodiscard]] const T& back() const noexcept { return data()[size_ - 1]; }

    void reserve(std::size_t count) {
        if (count > capacity_) make_room(count, sizeof(T));
    }
    void push_back(T value) {
        if (size_ == capacity_) make_room(size_ + 1, sizeof(T));
        data()[size_++] = value;
    }
    /// New records are T().
    void resize(std::size_t count) {
        reserve(count);
        for (std::size_t k = size_; k < count; ++k) data()[k] = T();
        size_ = count;
    }
    void assign(std::size_t count, T value) {
        reserve(count);
        for (std::size_t k = 0; k < count; ++k) data()[k] = value;
        size_ = count;
    }
    void clear() noexcept { size_ = 0; }
};

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/records.ipp>  // IWYU pragma: export
#endif
