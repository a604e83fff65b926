#include "breccia/homogenisation/study_sink.hpp"

#include "checkpoint/checkpoint.hpp"

namespace breccia {

std::unique_ptr<Checkpoint> StudySink::packing_checkpoint(const Stage& /*stage*/) {
  return nullptr;
}

std::unique_ptr<Checkpoint> StudySink::test_checkpoint(const Stage& /*stage*/, const TestId& /*test*/) {
  return nullptr;
}

}  // namespace breccia
