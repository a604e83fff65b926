#include "microstructure/growing_balls.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "microstructure/contact_time.hpp"
#include "microstructure/uniform.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia {

namespace {
constexpr std::uint64_t events_per_ball_and_epoch = 20;
// Least speed at which balls separate after a contact: with less, roundoff could make them touch again at once,
// forever.
constexpr double least_parting_speed = 1e-9;

}  // namespace

template <int dim>
GrowingBalls<dim>::GrowingBalls(double side, Walls walls, const std::vector<double>& diameters)
    : side_(side),
      walls_(walls),
      images_(side),
      bodies_(diameters.size()),
      next_(diameters.size()),
      queue_(diameters.size()),
      lists_(side, walls, {}, {}),
      events_per_epoch_(events_per_ball_and_epoch * diameters.size()) {
  for (std::size_t ball = 0; ball < diameters.size(); ++ball) {
    // Equal masses, and masses in proportion to the volume, both need more events at wide size ranges.
    bodies_[ball].mass = diameters[ball];
    bodies_[ball].radius = 0.5 * diameters[ball];
  }
}

template <int dim>
GrowingBalls<dim>::GrowingBalls(double side, Walls walls, const std::vector<double>& diameters, std::uint64_t seed)
    : GrowingBalls(side, walls, diameters) {
  std::mt19937_64 engine(seed);
  for (Body& body : bodies_) {
    for (double& x : body.position) x = side * uniform(engine);
    for (double& v : body.velocity) v = (2.0 * uniform(engine) - 1.0) / std::sqrt(body.mass);
  }
}

template <int dim>
GrowingBalls<dim>::GrowingBalls(double side, Walls walls, const std::vector<double>& diameters,
                                const PackingState<dim>& state)
    : GrowingBalls(side, walls, diameters) {
  for (std::size_t ball = 0; ball < diameters.size(); ++ball) {
    bodies_[ball].position = state.positions[ball];
    bodies_[ball].velocity = state.velocities[ball];
  }
  queue_ = EventQueue(state.queue, state.queue_times);
  scale_ = state.scale;
  events_ = state.events;
}

template <int dim>
void GrowingBalls<dim>::describe(PackingState<dim>& state) const {
  state.positions.clear();
  state.velocities.clear();
  for (const Body& body : bodies_) {
    state.positions.push_back(body.position);
    state.velocities.push_back(body.velocity);
  }
  state.queue = queue_.balls();
  state.queue_times = queue_.times();
  state.scale = scale_;
  state.events = events_;
}

template <int dim>
void GrowingBalls<dim>::grow(double rate) {
  const double largest_scale = std::min(1.0, 1.1 * scale_ + 0.1);
  const double stop = (largest_scale - scale_) / rate;
  rate_ = rate;
  cool();
  make_lists(largest_scale);
  predict_all();
  const std::uint64_t last_event = events_ + events_per_epoch_;
  while (events_ < last_event && bodies_[queue_.first()].next_event < stop) {
    now_ = bodies_[queue_.first()].next_event;
    handle(queue_.first());
    ++events_;
  }
  const bool reached = events_ < last_event;
  synchronise(reached ? stop : now_);
  if (reached) scale_ = largest_scale;
}

template <int dim>
void GrowingBalls<dim>::cool() {
  double twice_energy = 0.0;
  for (const Body& body : bodies_) twice_energy += body.mass * dot(body.velocity, body.velocity);
  if (twice_energy == 0.0) return;
  const double factor = std::sqrt(static_cast<double>(dim * bodies_.size()) / twice_energy);
  for (Body& body : bodies_) {
    for (double& v : body.velocity) v *= factor;
  }
}

template <int dim>
void GrowingBalls<dim>::make_lists(double largest_scale) {
  double cubes = 0.0;  // volume of cubes around the balls
  for (const Body& body : bodies_) cubes += std::pow(2.0 * scale_ * body.radius, dim);
  const double room = std::max(0.0, 1.0 - cubes / std::pow(side_, dim));
  const double spacing = side_ * std::pow(static_cast<double>(bodies_.size()), -1.0 / dim);
  // Domains are wide in a dilute packing and narrow in a dense one, where a ball has many neighbours; the exact width
  // matters little.
  skin_ = std::min((0.15 + 0.5 * room) * spacing, 0.1 * side_);
  std::vector<Vector<dim>> anchors;
  std::vector<double> domains;
  for (const Body& body : bodies_) {
    anchors.push_back(body.position);
    domains.push_back(largest_scale * body.radius + skin_);
  }
  lists_ = NeighbourLists<dim>(side_, walls_, std::move(anchors), std::move(domains));
}

template <int dim>
void GrowingBalls<dim>::predict_all() {
  now_ = 0.0;
  for (std::uint32_t ball = 0; ball < bodies_.size(); ++ball) {
    bodies_[ball].time = now_;
    bodies_[ball].next_event = never;
    next_[ball] = {};
  }
  for (std::uint32_t ball = 0; ball < bodies_.size(); ++ball) predict(ball);
}

template <int dim>
void GrowingBalls<dim>::synchronise(double time) {
  now_ = time;
  for (Body& body : bodies_) {
    advance(body);
    wrap(body.position);
  }
  scale_ += rate_ * time;
}

template <int dim>
void GrowingBalls<dim>::handle(std::uint32_t ball) {
  const Event event = take_event(ball);
  switch (event.kind) {
    case EventKind::none:
      break;
    case EventKind::contact:
      take_event(event.partner);
      collide(bodies_[ball], bodies_[event.partner], event.image);
      predict(event.partner);
      break;
    case EventKind::low_wall:
    case EventKind::high_wall:
      bounce(bodies_[ball], event);
      break;
    case EventKind::leave:
      wrap(bodies_[ball].position);
      lists_.move(ball, bodies_[ball].position);
      break;
  }
  predict(ball);
}

template <int dim>
typename GrowingBalls<dim>::Event GrowingBalls<dim>::take_event(std::uint32_t ball) noexcept {
  advance(bodies_[ball]);
  bodies_[ball].next_event = never;
  return std::exchange(next_[ball], {});
}

template <int dim>
void GrowingBalls<dim>::advance(Body& body) noexcept {
  body.position += (now_ - body.time) * body.velocity;
  body.time = now_;
}

/// A contact that is elastic in the frame of the growing surfaces: the balls separate as fast as the surfaces met, plus
/// the speed of the growth.
template <int dim>
void GrowingBalls<dim>::collide(Body& body, Body& partner, Image image) noexcept {
  Vector<dim> normal = partner.position + images_.shift(image) - body.position;
  const double distance = norm(normal);
  for (double& n : normal) n /= distance;
  const double parting = dot(partner.velocity - body.velocity, normal);
  const double growth = rate_ * (body.radius + partner.radius);
  const double meeting = growth - parting;
  const double change = meeting + std::max(meeting, least_parting_speed);
  const double share = partner.mass / (body.mass + partner.mass);
  body.velocity -= change * share * normal;
  partner.velocity += change * (1.0 - share) * normal;
}

template <int dim>
void GrowingBalls<dim>::bounce(Body& body, const Event& event) noexcept {
  const double growth = rate_ * body.radius;
  double& v = body.velocity[event.partner];
  v = event.kind == EventKind::low_wall ? 2.0 * growth - v : -2.0 * growth - v;
}

template <int dim>
void GrowingBalls<dim>::wrap(Vector<dim>& position) const noexcept {
  if (walls_ == Walls::hard) return;
  for (double& x : position) x = wrapped(x, side_);
}

template <int dim>
void GrowingBalls<dim>::predict(std::uint32_t ball) {
  const Body& body = bodies_[ball];
  Event event{EventKind::leave};
  double time = now_ + leave_time(body.position - lists_.anchor(ball), body.velocity, skin_);
  if (walls_ == Walls::hard) predict_walls(body, event, time);
  const double scale = scale_ + rate_ * now_;
  for (const auto& [other, image] : lists_.of(ball)) {
    const Body& partner = bodies_[other];
    const Vector<dim> position = partner.position + (now_ - partner.time) * partner.velocity + images_.shift(image);
    const double radii = body.radius + partner.radius;
    const double contact =
        now_ + contact_time(position - body.position, partner.velocity - body.velocity, scale * radii, rate_ * radii);
    if (contact < time && contact < partner.next_event) {
      event = {EventKind::contact, other, image};
      time = contact;
    }
  }
  schedule(ball, event, time);
}

template <int dim>
void GrowingBalls<dim>::predict_walls(const Body& body, Event& event, double& time) const noexcept {
  const double radius = (scale_ + rate_ * now_) * body.radius;
  const double growth = rate_ * body.radius;
  for (std::uint32_t axis = 0; axis < dim; ++axis) {
    const double x = body.position[axis];
    const double v = body.velocity[axis];
    const double low = v < growth ? now_ + std::max(0.0, x - radius) / (growth - v) : never;
    if (low < time) {
      event = {EventKind::low_wall, axis};
      time = low;
    }
    const double high = v > -growth ? now_ + std::max(0.0, side_ - x - radius) / (growth + v) : never;
    if (high < time) {
      event = {EventKind::high_wall, axis};
      time = high;
    }
  }
}

template <int dim>
void GrowingBalls<dim>::schedule(std::uint32_t ball, const Event& event, double time) {
  next_[ball] = event;
  bodies_[ball].next_event = time;
  queue_.set(ball, time);
  if (event.kind != EventKind::contact) return;
  Event& of_partner = next_[event.partner];
  // The ball that the partner would have met has lost this contact; its next event is predicted at the time of it.
  if (of_partner.kind == EventKind::contact) next_[of_partner.partner].kind = EventKind::none;
  of_partner = {EventKind::contact, ball, PeriodicImages<dim>::opposite(event.image)};
  bodies_[event.partner].next_event = time;
  queue_.set(event.partner, time);
}

template class GrowingBalls<2>;
template class GrowingBalls<3>;
}  // namespace breccia
