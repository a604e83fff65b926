#include "io/seal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "io/hdf5.hpp"
#include "io/text_file.hpp"
#include "messages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

class Seal : public testing::Test {
 protected:
  [[nodiscard]] std::string complaint() const {
    return test::message_of<FileError>([this] { require_sealed(path_); });
  }

  test::TemporaryDirectory directory_;
  std::filesystem::path path_ = directory_.path() / "file";
};

TEST_F(Seal, HoldsForEveryLength) {
  for (const std::size_t length : {0U, 1U, 63U, 64U, 65U, 5000U}) {
    write_text(path_, std::string(length, '\n'));
    seal(path_);
    EXPECT_NO_THROW(require_sealed(path_)) << length;
  }
}

TEST_F(Seal, BreaksWithAnyByte) {
  write_text(path_, "what is to be kept");
  seal(path_);
  const auto sealed = read_text(path_);
  for (std::size_t i = 0; i < sealed.size(); ++i) {
    auto damaged = sealed;
    damaged[i] = static_cast<char>(damaged[i] ^ 1);
    write_text(path_, damaged);
    EXPECT_THAT(complaint(), testing::StartsWith(path_.string() + ": ")) << i;
  }
}

TEST_F(Seal, BreaksWhereAFileIsCutOrLonger) {
  write_text(path_, "what is to be kept");
  seal(path_);
  const auto sealed = read_text(path_);
  for (std::size_t length = 0; length < sealed.size(); ++length) {
    write_text(path_, sealed.substr(0, length));
    EXPECT_THAT(complaint(), testing::HasSubstr("torn, or no checkpoint of Breccia")) << length;
  }
  write_text(path_, sealed + "more");
  EXPECT_THAT(complaint(), testing::HasSubstr("torn, or no checkpoint of Breccia"));
}

TEST_F(Seal, AMissingFileIsNamed) {
  EXPECT_EQ(complaint(), path_.string() + ": cannot read: No such file or directory");
}

TEST_F(Seal, HDF5ReadsWhatIsSealed) {
  Hdf5Writer writer(path_);
  writer.write("/numbers", std::vector<double>{1.0, 2.0});
  writer.commit();
  seal(path_);
  EXPECT_THAT(Hdf5Reader(path_).read_numbers("/numbers"), testing::ElementsAre(1.0, 2.0));
}

}  // namespace
}  // namespace breccia
