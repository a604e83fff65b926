#include "io/hdf5.hpp"

#include <span>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Numbers = std::vector<double>;
using Integers = std::vector<std::int64_t>;

class Hdf5 : public testing::Test {
 protected:
  test::TemporaryDirectory directory;
  std::filesystem::path path = directory.path() / "file.h5";
};

TEST_F(Hdf5, RoundTripOfDatasets) {
  const Numbers numbers{1.0, 1.0 / 3.0, -2e300, 0.0, 5e-324, 7.0};
  const Integers integers{1, -2, std::int64_t{1} << 62};
  Hdf5Writer writer(path);
  writer.create<double>("/history/stress", {2, 3});
  writer.write_part("/history/stress", 0, std::span(numbers));
  writer.write("/history/steps", integers);
  writer.commit();

  const Hdf5Reader reader(path);
  EXPECT_EQ(reader.read_numbers("/history/stress"), numbers);
  EXPECT_THAT(reader.shape("/history/stress"), ElementsAre(2U, 3U));
  EXPECT_EQ(reader.read_integers("/history/steps"), integers);
  EXPECT_THAT(reader.names("/history"), ElementsAre("steps", "stress"));
}

TEST_F(Hdf5, ReadsSomeOfADataset) {
  const Numbers numbers{1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0};
  Hdf5Writer writer(path);
  writer.create_compressed<double>("/rows", {4, 2});
  writer.write_part("/rows", 0, std::span(numbers));
  writer.write("/line", numbers);
  writer.commit();
  const Hdf5Reader reader(path);
  EXPECT_THAT(reader.read_numbers("/rows", 1, 2), ElementsAre(3.0, 4.0, 5.0, 6.0));
  EXPECT_THAT(reader.read_numbers("/line", 6, 2), ElementsAre(7.0, 8.0));
  EXPECT_THAT(reader.read_numbers("/line", 8, 0), IsEmpty());
  for (const std::size_t first : {3U, 7U}) {
    EXPECT_THAT(test::message_of<FileError>([&] { static_cast<void>(reader.read_numbers("/rows", first, 2)); }),
                HasSubstr("cannot find so many values in dataset /rows"));
  }
  EXPECT_THROW(static_cast<void>(reader.read_numbers("/columns", 0, 1)), FileError);
}

TEST_F(Hdf5, DatasetsAreWrittenInParts) {
  const std::vector<float> numbers = {1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F};
  Hdf5Writer writer(path);
  writer.create_compressed<float>("/rows", {3, 2});
  writer.write_part("/rows", 1, std::span(numbers).subspan(2));
  writer.write_part("/rows", 0, std::span(numbers).first(2));
  writer.write_part("/rows", 3, std::span(numbers).first(0));
  const auto refused = [&](std::size_t first, std::size_t count) {
    return test::message_of<FileError>([&] { writer.write_part("/rows", first, std::span(numbers).first(count)); });
  };
  EXPECT_THAT(refused(2, 4), HasSubstr("values, of 2 each and from 2 on, into the 3 of /rows"));
  EXPECT_THAT(refused(0, 3), HasSubstr("values, of 2 each and from 0 on, into the 3 of /rows"));
  writer.commit();
  EXPECT_THAT(Hdf5Reader(path).read_numbers("/rows"), ElementsAre(1.0, 2.0, 3.0, 4.0, 5.0, 6.0));
}

TEST_F(Hdf5, RoundTripOfAttributes) {
  Hdf5Writer writer(path);
  writer.create_group("/a/b");
  writer.write_attribute("/a/b", "text", "ImageData");
  writer.write_attribute("/a/b", "nothing", "");
  writer.write_attribute("/a/b", "number", 0.1);
  writer.write_attribute("/a/b", "integer", 42);
  writer.write_attribute("/a/b", "numbers", Numbers{0.5, 2.0});
  writer.write_attribute("/a/b", "integers", Integers{1, 0});
  writer.commit();

  const Hdf5Reader reader(path);
  EXPECT_EQ(reader.attribute<std::string>("/a/b", "text"), "ImageData");
  EXPECT_EQ(reader.attribute<std::string>("/a/b", "nothing"), "");
  EXPECT_EQ(reader.attribute<double>("/a/b", "number"), 0.1);
  EXPECT_EQ(reader.attribute<std::int64_t>("/a/b", "integer"), 42);
  EXPECT_THAT(reader.attribute<Numbers>("/a/b", "numbers"), ElementsAre(0.5, 2.0));
  EXPECT_THAT(reader.attribute<Integers>("/a/b", "integers"), ElementsAre(1, 0));
}

TEST_F(Hdf5, EmptyDatasetsExist) {
  Hdf5Writer writer(path);
  writer.write("/none", Numbers{});
  writer.commit();
  EXPECT_THAT(Hdf5Reader(path).read_numbers("/none"), IsEmpty());
}

TEST_F(Hdf5, NothingAppearsBeforeCommit) {
  {
    Hdf5Writer writer(path);
    writer.write("/x", Numbers{1.0});
    EXPECT_FALSE(std::filesystem::exists(path));
  }
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

TEST_F(Hdf5, ErrorsNameFileAndObject) {
  Hdf5Writer writer(path);
  writer.write("/x", Numbers{1.0});
  writer.write_attribute("/x", "unit", "Pa");
  EXPECT_EQ(test::message_of<FileError>([&] { writer.write("/x", Numbers{1.0}); }),
            path.string() + ": cannot create dataset /x");
  EXPECT_EQ(test::message_of<FileError>([&] { writer.write_attribute("/y", "unit", "Pa"); }),
            path.string() + ": cannot attach an attribute to /y");
  writer.commit();

  const Hdf5Reader reader(path);
  EXPECT_TRUE(reader.has("/x"));
  EXPECT_FALSE(reader.has("/y"));
  EXPECT_EQ(test::message_of<FileError>([&] { static_cast<void>(reader.read_numbers("/y")); }),
            path.string() + ": cannot open dataset /y");
  EXPECT_THROW(static_cast<void>(reader.read_integers("/x")), FileError);
  EXPECT_THROW(static_cast<void>(reader.names("/x")), FileError);
  EXPECT_THROW(static_cast<void>(reader.attribute<double>("/x", "unit")), FileError);
  EXPECT_THAT(test::message_of<FileError>([&] { static_cast<void>(reader.read_attribute("/x", "color")); }),
              HasSubstr("cannot find attribute color of /x"));
}

TEST_F(Hdf5, DamagedFilesAreRefused) {
  Hdf5Writer writer(path);
  writer.write("/x", Numbers(1000, 1.0));
  writer.commit();
  testing::internal::CaptureStderr();
  EXPECT_THROW(Hdf5Reader(directory.path() / "none.h5"), FileError);
  EXPECT_THROW(Hdf5Reader(directory.written("text.h5", "not HDF5")), FileError);
  std::filesystem::resize_file(path, 3000);
  EXPECT_THROW(static_cast<void>(Hdf5Reader(path).read_numbers("/x")), FileError);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "the library prints nothing of its own";
}

TEST_F(Hdf5, AMissingDirectoryIsAFileError) {
  EXPECT_THROW(Hdf5Writer(directory.path() / "no" / "file.h5"), FileError);
}

}  // namespace
}  // namespace breccia
