// Tests of the mistakes in images that a program makes.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/study/soundness.hpp"

#include "messages.hpp"
#include "study/two_stages.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

ImagePacking<2> packing_of(LabelImage<2> image) {
  return {.file = "scan.png", .image = std::make_shared<const LabelImage<2>>(std::move(image))};
}

/// A study of two stages, of which the first is an image of 2 x 2 pixels.
Study sound_study() {
  auto study = test::two_stages();
  auto& stage = study.stages.front();
  stage.fillers.front().sizes.reset();
  stage.packing = packing_of({{2, 2}, 0.5 * stage.side, Walls::hard, {0, 1, 1, 0}});
  return study;
}

TEST(ImageSoundness, OfAnImageThatFillsItsBox) {
  EXPECT_NO_THROW(require_sound(sound_study()));
}

TEST(ImageSoundness, EachMistakeIsTold) {
  struct Case {
    std::function<void(Stage&)> make;
    std::string message;
  };
  const std::vector<Case> cases = {
      {[](Stage& stage) { stage.packing = ImagePacking<2>{}; }, "expected an image"},
      {[](Stage& stage) {
         stage.packing = packing_of({{2, 2}, 0.5 * stage.side, Walls::hard, {0, 1, 2, 0}});
       },
       "a pixel has the label 2, counted from 0, but there are only 2"},
      {[](Stage& stage) {
         stage.packing = packing_of({{2, 2}, 0.5 * stage.side, Walls::hard, {0, 1}});
       },
       "2 labels; expected 4"},
      {[](Stage& stage) {
         stage.packing = packing_of({{2, 1}, 0.5 * stage.side, Walls::hard, {0, 1}});
       },
       "expected a square image, got 2 x 1 pixels"},
      {[](Stage& stage) {
         stage.packing = packing_of({{2, 2}, 0.6 * stage.side, Walls::hard, {0, 1, 1, 0}});
       },
       "expected 2 pixels that fill the box"},
      {[](Stage& stage) { stage.fillers.front().fraction = 0.5; }, "expected neither sizes nor a fraction"},
      {[](Stage& stage) { stage.fillers.front().gap = 1e-3; }, "expected no gap"},
      {[](Stage& stage) {
         stage.fillers.front().coating = Coating{test::binder, 1e-4};
       },
       "expected no coating"},
  };
  for (const auto& [make, message] : cases) {
    auto study = sound_study();
    make(study.stages.front());
    EXPECT_THAT(test::message_of<InputError>([&] { require_sound(study); }),
                AllOf(HasSubstr(message), Not(HasSubstr("\n"))))
        << message;
  }
}

}  // namespace
}  // namespace breccia
