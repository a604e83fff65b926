#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace breccia::dynamics {

/// Allocator whose memory begins at a cache line, so that no register of a block straddles two lines.
template <class T>
struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::align_val_t alignment{64};

  CacheLineAllocator() = default;
  template <class U>
  explicit CacheLineAllocator(const CacheLineAllocator<U>& /*other*/) noexcept {}

  [[nodiscard]] T* allocate(std::size_t count) { return static_cast<T*>(::operator new(count * sizeof(T), alignment)); }
  void deallocate(T* memory, std::size_t /*count*/) noexcept { ::operator delete(memory, alignment); }

  friend bool operator==(const CacheLineAllocator&, const CacheLineAllocator&) = default;
};

using AlignedVector = std::vector<double, CacheLineAllocator<double>>;

}  // namespace breccia::dynamics
