#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "contact_time.hpp"

namespace breccia {

/// The next event of every ball, with access to the earliest: a four-ary heap of (time, ball) that knows the place of
/// each ball.
class EventQueue {
 public:
  explicit EventQueue(std::size_t balls) : heap_(balls), place_(balls) {
    for (std::uint32_t ball = 0; ball < balls; ++ball) put(ball, {never, ball});
  }
  /// Restores a queue: the ball at each place in the heap, every ball once, and the times of their events.
  EventQueue(const std::vector<std::uint32_t>& balls, const std::vector<double>& times)
      : heap_(balls.size()), place_(balls.size()) {
    for (std::size_t place = 0; place < balls.size(); ++place) put(place, {times[place], balls[place]});
  }

  /// Of two balls with events at the same time, their places in the heap decide which is first.
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

  /// The parent of a place in the heap; the first place is its own parent.
  [[nodiscard]] static std::size_t above(std::size_t place) noexcept { return place > 0 ? (place - 1) / arity : 0; }

  [[nodiscard]] std::uint32_t first() const noexcept { return heap_.front().ball; }

  void set(std::uint32_t ball, double time) noexcept {
    const std::size_t place = place_[ball];
    if (time < heap_[place].time) {
      rise(place, {time, ball});
    } else {
      sink(place, {time, ball});
    }
  }

 private:
  static constexpr std::size_t arity = 4;
  struct Item {
    double time;
    std::uint32_t ball;
  };

  void put(std::size_t place, const Item& item) noexcept {
    heap_[place] = item;
    place_[item.ball] = static_cast<std::uint32_t>(place);
  }

  void rise(std::size_t place, const Item& item) noexcept {
    while (place > 0) {
      const std::size_t parent = above(place);
      if (!(item.time < heap_[parent].time)) break;
      put(place, heap_[parent]);
      place = parent;
    }
    put(place, item);
  }

  void sink(std::size_t place, const Item& item) noexcept {
    for (std::size_t child = arity * place + 1; child < heap_.size(); child = arity * place + 1) {
      const std::size_t end = child + arity < heap_.size() ? child + arity : heap_.size();
      std::size_t earliest = child;
      for (++child; child < end; ++child) {
        if (heap_[child].time < heap_[earliest].time) earliest = child;
      }
      if (!(heap_[earliest].time < item.time)) break;
      put(place, heap_[earliest]);
      place = earliest;
    }
    put(place, item);
  }

  std::vector<Item> heap_;
  std::vector<std::uint32_t> place_;  // of each ball in the heap
};

}  // namespace breccia
