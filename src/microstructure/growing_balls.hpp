#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "breccia/microstructure/microstructure.hpp"
#include "breccia/microstructure/packing.hpp"

#include "microstructure/event_queue.hpp"
#include "microstructure/neighbour_lists.hpp"
#include "microstructure/periodic_images.hpp"

namespace breccia {

/// Hard balls that move freely, collide, and grow in proportion to their final size: the molecular dynamics of
/// Lubachevsky and Stillinger (1990), event by event. Lengths are in mean final diameters; speeds are of order one.
///
/// Time passes in epochs. Between two epochs all balls are advanced to the same time, the clock is set back to zero (so
/// that it loses no digits), the kinetic energy gained from the growth is removed, and the neighbour lists are made for
/// the growth of the next epoch.
template <int dim>
class GrowingBalls {
 public:
  /// Starts with points at random positions with random velocities. `diameters` are the final diameters, at scale 1.
  GrowingBalls(double side, Walls walls, const std::vector<double>& diameters, std::uint64_t seed);
  /// Continues from a state between two epochs.
  GrowingBalls(double side, Walls walls, const std::vector<double>& diameters, const PackingState<dim>& state);

  /// Present size of the balls, as a share of the final one.
  [[nodiscard]] double scale() const noexcept { return scale_; }
  [[nodiscard]] std::uint64_t events() const noexcept { return events_; }
  [[nodiscard]] const Vector<dim>& centre(std::size_t ball) const noexcept { return bodies_[ball].position; }

  /// Runs one epoch: the scale grows at `rate` (per time) until it is exactly 1, or has grown by more than a tenth, or
  /// each ball has had some twenty events.
  void grow(double rate);
  /// Makes the balls smaller by a factor.
  void shrink(double factor) noexcept { scale_ *= factor; }

  /// Describes the state between two epochs.
  void describe(PackingState<dim>& state) const;

 private:
  using Image = typename PeriodicImages<dim>::Image;
  struct Body {  // one cache line in 2D
    Vector<dim> position;
    Vector<dim> velocity;
    double time;    // time at which the ball is at `position`
    double radius;  // radius at scale 1
    double mass;
    double next_event;  // time of the next event of the ball
  };
  enum class EventKind : std::uint8_t {
    none,       // no event is known, because the partner has found another one: the next event must be searched again
    contact,    // contact with another ball
    low_wall,   // contact with the wall at 0
    high_wall,  // contact with the wall at the side of the box
    leave       // the ball leaves its domain
  };
  struct Event {
    EventKind kind = EventKind::none;
    std::uint32_t partner = 0;  // number of the other ball, or of the axis of the wall
    Image image = 0;            // the image of the partner
  };

  /// Starts with points at rest in a corner.
  GrowingBalls(double side, Walls walls, const std::vector<double>& diameters);

  void cool();
  void make_lists(double largest_scale);
  void predict_all();
  void synchronise(double time);
  void handle(std::uint32_t ball);
  Event take_event(std::uint32_t ball) noexcept;
  void advance(Body& body) noexcept;
  void collide(Body& body, Body& partner, Image image) noexcept;
  void bounce(Body& body, const Event& event) noexcept;
  void wrap(Vector<dim>& position) const noexcept;
  void predict(std::uint32_t ball);
  void predict_walls(const Body& body, Event& event, double& time) const noexcept;
  void schedule(std::uint32_t ball, const Event& event, double time);

  double side_ = 0.0;
  Walls walls_ = Walls::hard;
  PeriodicImages<dim> images_;
  std::vector<Body> bodies_;
  std::vector<Event> next_;
  EventQueue queue_;
  NeighbourLists<dim> lists_;
  double now_ = 0.0;
  double skin_ = 0.0;   // distance that a ball may move from the anchor of its domain
  double scale_ = 0.0;  // scale at time 0
  double rate_ = 0.0;   // growth rate of the scale
  std::uint64_t events_ = 0;
  std::uint64_t events_per_epoch_ = 0;
};

}  // namespace breccia
