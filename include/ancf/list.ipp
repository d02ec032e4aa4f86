// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/list.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <vector>

namespace ancf::detail {

ANCF_INLINE void* ListStorage::allocate(std::size_t capacity, std::size_t item,
                                        std::size_t alignment) {
    if (capacity > PTRDIFF_MAX / item) throw std::bad_array_new_length();
    const std::size_t bytes = item * capacity;
    return alignment > __STDCPP_DEFAULT_NEW_ALIGNMENT__
               ? ::operator new(bytes, std::align_val_t(alignment))
               : ::operator new(bytes);
}

ANCF_INLINE void ListStorage::release(void* data, std::size_t alignment) noexcept {
    if (alignment > __STDCPP_DEFAULT_NEW_ALIGNMENT__)
        ::operator delete(data, std::align_val_t(alignment));
    else
        ::operator delete(data);
}

ANCF_INLINE void ListStorage::make_room(std::size_t count, std::size_t item,
                                        std::size_t alignment) {
    const std::size_t capacity = grown(count);
    void* const data = allocate(capacity, item, alignment);
    if (size_ > 0) std::memcpy(data, data_, size_ * item);
    release(data_, alignment);
    data_ = data;
    capacity_ = capacity;
}

ANCF_INLINE void ListStorage::copy(const ListStorage& other, std::size_t item,
                                   std::size_t alignment) {
    size_ = 0;
    if (other.size_ > capacity_) make_room(other.size_, item, alignment);
    if (other.size_ > 0) std::memcpy(data_, other.data_, other.size_ * item);
    size_ = other.size_;
}

ANCF_INLINE std::size_t ListStorage::within(std::size_t k) const {
    // std::vector throws it: the header that has it is longer than all others here
    if (k >= size_) (void)std::vector<char>().at(k);
    return k;
}

}  // namespace ancf::detail
