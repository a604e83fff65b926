#include "homogenisation/box/packing_runner.hpp"

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "homogenisation/box/microstructure_measures.hpp"
#include "homogenisation/box/packing_state.hpp"

namespace breccia {

PackingRunner::PackingRunner(const Stage& stage, const ProgressObserver& follow, Checkpoint* checkpoint)
    : stage_(stage),
      follow_(follow),
      checkpoint_(checkpoint),
      earlier_(checkpoint != nullptr ? checkpoint->earlier() : nullptr),
      seconds_before_(earlier_ != nullptr ? earlier_->number(packing_seconds_name) : 0.0) {}

template <int dim>
Packing<dim> PackingRunner::run(const PackingRequest& request) {
  auto packing = earlier_ != nullptr ? go_on<dim>(request) : PackingRun<dim>(request);
  while (!packing.is_done()) {
    packing.advance();
    report(packing.progress());
    if (checkpoint_ == nullptr || !checkpoint_->is_due()) continue;
    checkpoint_->save([&](StateWriter& state) {
      save(state, packing.state());
      state.write(packing_seconds_name, seconds());
    });
  }
  return packing.packing();
}

template <class Request>
void PackingRunner::run(SequentialRun<Request>& packing) {
  while (!packing.is_done()) {
    packing.advance();
    report(packing.progress());
    if (checkpoint_ == nullptr || !checkpoint_->is_due()) continue;
    checkpoint_->save([&](StateWriter& state) { state.write(packing_seconds_name, seconds()); });
  }
}

double PackingRunner::seconds() const {
  return seconds_before_ + std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

template <int dim>
PackingRun<dim> PackingRunner::go_on(const PackingRequest& request) const {
  try {
    return {request, read_packing_state<dim>(*earlier_)};
  } catch (const InputError& error) {
    throw FileError(fmt::format("{}: {}; start anew instead of resuming", earlier_->path(), error.what()));
  }
}

void PackingRunner::report(const PackingProgress& packing) const {
  if (!follow_) return;
  follow_({.what = stage_.name + ": packing",
           .share = packing.fraction / packing.fraction_to_reach,
           .details = fmt::format("{} events", packing.events)});
}

template Packing<2> PackingRunner::run(const PackingRequest&);
template Packing<3> PackingRunner::run(const PackingRequest&);
template void PackingRunner::run(SequentialRun<RandomSequentialRequest>&);
template void PackingRunner::run(SequentialRun<EllipsoidSequentialRequest>&);

}  // namespace breccia
