#include "checkpoint/checkpoint.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "io/text_file.hpp"
#include "messages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A calculation whose state is one number.
class CheckpointTest : public testing::Test {
 protected:
  [[nodiscard]] Checkpoint opened(const StateOwner& owner, CheckpointSchedule schedule = {}) const {
    return {path_, owner, std::move(schedule)};
  }
  [[nodiscard]] Checkpoint opened() const { return opened(owner_); }

  static WriteState state(double number) {
    return [number](StateWriter& writer) { writer.write("/number", number); };
  }
  /// The number that another run finds.
  [[nodiscard]] double found() const {
    auto checkpoint = opened();
    EXPECT_THAT(checkpoint.look_for_earlier(), IsEmpty());
    return checkpoint.earlier() != nullptr ? checkpoint.earlier()->number("/number") : -1.0;
  }
  void damage(const std::filesystem::path& path) const {
    auto bytes = read_text(path);
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    write_text(path, bytes);
  }

  test::TemporaryDirectory directory_;
  std::filesystem::path path_ = directory_.path() / "a.checkpoint.h5";
  StateOwner owner_ = {"0123", "1.0"};
};

TEST_F(CheckpointTest, KeepsEveryKindOfNumberToTheLastBit) {
  const std::vector<double> numbers = {0.1, -0.0, std::numeric_limits<double>::denorm_min(),
                                       std::numeric_limits<double>::infinity()};
  auto checkpoint = opened();
  checkpoint.save([&](StateWriter& writer) {
    writer.write("/group/numbers", numbers);
    writer.write("/integer", std::numeric_limits<std::int64_t>::min());
    writer.write("/text", std::string("a text"));
    writer.write("/nothing", std::vector<double>());
  });
  const StateReader reader(path_);
  EXPECT_EQ(reader.numbers("/group/numbers", 4), numbers);
  EXPECT_TRUE(std::signbit(reader.numbers("/group/numbers")[1]));
  EXPECT_EQ(reader.integer("/integer"), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(reader.text("/text"), "a text");
  EXPECT_THAT(reader.numbers("/nothing"), IsEmpty());
  EXPECT_FALSE(reader.has("/other"));
  EXPECT_THAT(test::message_of<FileError>([&] { static_cast<void>(reader.numbers("/group/numbers", 3)); }),
              HasSubstr("expected 3 numbers as /group/numbers, got 4"));
}

TEST_F(CheckpointTest, WithoutAnEarlierRunThereIsNothing) {
  auto checkpoint = opened();
  EXPECT_THAT(checkpoint.look_for_earlier(), IsEmpty());
  EXPECT_EQ(checkpoint.earlier(), nullptr);
  EXPECT_FALSE(checkpoint.is_finished());
}

TEST_F(CheckpointTest, TheLastStateCounts) {
  auto checkpoint = opened();
  checkpoint.save(state(1.0));
  checkpoint.save(state(2.0));
  EXPECT_EQ(found(), 2.0);
  EXPECT_EQ(StateReader(older_state(path_)).number("/number"), 1.0);
}

TEST_F(CheckpointTest, ATornStateIsNamedAndTheOlderOneUsed) {
  auto checkpoint = opened();
  checkpoint.save(state(1.0));
  checkpoint.save(state(2.0));
  damage(path_);
  auto other = opened();
  EXPECT_THAT(other.look_for_earlier(),
              ElementsAre(path_.string() + ": damaged: wrong checksum; the previous checkpoint is used"));
  ASSERT_NE(other.earlier(), nullptr);
  EXPECT_EQ(other.earlier()->number("/number"), 1.0);
  other.save(state(3.0));
  EXPECT_EQ(StateReader(older_state(path_)).number("/number"), 1.0) << "the good one stays the older one";
}

TEST_F(CheckpointTest, WithBothTornItBeginsAnew) {
  auto checkpoint = opened();
  checkpoint.save(state(1.0));
  checkpoint.save(state(2.0));
  damage(older_state(path_));
  write_text(path_, "of another program");
  auto other = opened();
  EXPECT_THAT(other.look_for_earlier(),
              ElementsAre(HasSubstr("no checkpoint of Breccia; this packing or test starts anew"),
                          HasSubstr("damaged: wrong checksum; this packing or test starts anew")));
  EXPECT_EQ(other.earlier(), nullptr);
}

TEST_F(CheckpointTest, BetweenTwoNamesTheOlderOneIsFound) {
  auto checkpoint = opened();
  checkpoint.save(state(1.0));
  // The files of a run that was killed after the first of two renamings.
  std::filesystem::rename(path_, older_state(path_));
  EXPECT_EQ(found(), 1.0);
}

TEST_F(CheckpointTest, ARunOfAnotherDeckOrVersionIsRefused) {
  auto checkpoint = opened();
  checkpoint.save(state(1.0));
  auto of_other_deck = opened({"4567", "1.0"});
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(of_other_deck.look_for_earlier()); }),
              HasSubstr("another deck: a value, a seed, an override or a data file differs"));
  auto of_other_version = opened({"0123", "1.1"});
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(of_other_version.look_for_earlier()); }),
              HasSubstr("saved by version 1.0 of Breccia, this is version 1.1"));
}

TEST_F(CheckpointTest, AResultIsRecognised) {
  auto checkpoint = opened();
  checkpoint.save(state(1.0));
  checkpoint.finish(state(2.0));
  auto other = opened();
  static_cast<void>(other.look_for_earlier());
  EXPECT_TRUE(other.is_finished());
}

TEST_F(CheckpointTest, AFinishedCalculationKeepsItsResultAlone) {
  auto checkpoint = opened();
  checkpoint.save(state(1.0));
  checkpoint.save(state(2.0));
  ASSERT_TRUE(std::filesystem::exists(older_state(path_)));
  checkpoint.finish(state(3.0));
  EXPECT_FALSE(std::filesystem::exists(older_state(path_)));
  EXPECT_EQ(found(), 3.0);
}

// On several processes no process may stop between two parts that all of them gather.
TEST_F(CheckpointTest, AStateThatCannotBeWrittenFailsAtItsEnd) {
  Checkpoint checkpoint(directory_.path() / "missing" / "a.checkpoint.h5", owner_, {});
  bool is_at_end = false;
  EXPECT_THROW(checkpoint.save([&](StateWriter& writer) {
    writer.write("/number", 1.0);
    is_at_end = true;
  }),
               FileError);
  EXPECT_TRUE(is_at_end);
}

TEST_F(CheckpointTest, WhatCannotBeLookedAtIsAFileError) {
  std::filesystem::create_symlink(path_.filename(), path_);
  auto checkpoint = opened();
  EXPECT_THROW(static_cast<void>(checkpoint.look_for_earlier()), FileError);
}

TEST_F(CheckpointTest, IsDueAfterTheInterval) {
  EXPECT_FALSE(opened(owner_, {.interval = 1e6}).is_due());
  EXPECT_TRUE(opened(owner_, {.interval = 0.0}).is_due());
}

TEST_F(CheckpointTest, AnEndOfTheRunIsDueAtOnceAndLeavesTheState) {
  auto checkpoint = opened(owner_, {.interval = 1e6, .stop = [] { return true; }});
  ASSERT_TRUE(checkpoint.is_due());
  EXPECT_EQ(test::message_of<Interrupted>([&] { checkpoint.save(state(3.0)); }), "interrupted; the state is saved");
  EXPECT_EQ(found(), 3.0);
}

}  // namespace
}  // namespace breccia
