#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "microstructure/contact_time.hpp"

namespace breccia {

/// The next event of every ball, with access to the earliest: a four-ary heap of (time, ball), with the slot of
/// each ball.
class EventQueue {
 public:
  explicit EventQueue(std::size_t balls) : heap_(balls), slot_(balls) {
    for (std::uint32_t ball = 0; ball < balls; ++ball) put(ball, {never, ball});
  }
  /// Restores a queue from the ball in each slot of the heap, every ball once, and the times of their events.
  EventQueue(const std::vector<std::uint32_t>& balls, const std::vector<double>& times)
      : heap_(balls.size()), slot_(balls.size()) {
    for (std::size_t slot = 0; slot < balls.size(); ++slot) put(slot, {times[slot], balls[slot]});
  }

  /// The ball in each slot of the heap. The slots determine which of two simultaneous events is first.
  [[nodiscard]] std::vector<std::uint32_t> balls() const {
    std::vector<std::uint32_t> all;
    all.reserve(heap_.size());
    for (const auto& item : heap_) all.push_back(item.ball);
    return all;
  }
  [[nodiscard]] std::vector<double> times() const {
    std::vector<double> all;
    all.reserve(heap_.size());
    for (const auto& item : heap_) all.push_back(item.time);
    return all;
  }

  /// The parent of a slot in the heap; the first slot is its own parent.
  [[nodiscard]] static std::size_t above(std::size_t slot) noexcept { return slot > 0 ? (slot - 1) / arity : 0; }

  [[nodiscard]] std::uint32_t first() const noexcept { return heap_.front().ball; }

  void set(std::uint32_t ball, double time) noexcept {
    const std::size_t slot = slot_[ball];
    if (time < heap_[slot].time) {
      rise(slot, {time, ball});
    } else {
      sink(slot, {time, ball});
    }
  }

 private:
  static constexpr std::size_t arity = 4;
  struct Item {
    double time;
    std::uint32_t ball;
  };

  void put(std::size_t slot, const Item& item) noexcept {
    heap_[slot] = item;
    slot_[item.ball] = static_cast<std::uint32_t>(slot);
  }

  void rise(std::size_t slot, const Item& item) noexcept {
    while (slot > 0) {
      const std::size_t parent = above(slot);
      if (!(item.time < heap_[parent].time)) break;
      put(slot, heap_[parent]);
      slot = parent;
    }
    put(slot, item);
  }

  void sink(std::size_t slot, const Item& item) noexcept {
    for (std::size_t child = arity * slot + 1; child < heap_.size(); child = arity * slot + 1) {
      const std::size_t end = child + arity < heap_.size() ? child + arity : heap_.size();
      std::size_t earliest = child;
      for (++child; child < end; ++child) {
        if (heap_[child].time < heap_[earliest].time) earliest = child;
      }
      if (!(heap_[earliest].time < item.time)) break;
      put(slot, heap_[earliest]);
      slot = earliest;
    }
    put(slot, item);
  }

  std::vector<Item> heap_;
  std::vector<std::uint32_t> slot_;  // slot of each ball in the heap
};

}  // namespace breccia
