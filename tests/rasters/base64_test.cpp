#include "rasters/base64.hpp"

#include <string>

#include <gtest/gtest.h>

#include "rasters/zlib_stream.hpp"

namespace breccia {
namespace {

using namespace std::string_literals;

// The examples of RFC 4648, section 10.
TEST(Base64, IsThatOfItsStandard) {
  for (const auto& [bytes, text] : {std::pair{""s, ""s},
                                    {"f"s, "Zg=="s},
                                    {"fo"s, "Zm8="s},
                                    {"foo"s, "Zm9v"s},
                                    {"foob"s, "Zm9vYg=="s},
                                    {"fooba"s, "Zm9vYmE="s},
                                    {"foobar"s, "Zm9vYmFy"s},
                                    {"\xff\x00\xfb"s, "/wD7"s}}) {
    EXPECT_EQ(encode_base64(bytes), text);
    EXPECT_EQ(decode_base64(text), bytes);
  }
}

// RFC 1950: the header is a multiple of 31 and names deflate; the sum at the end is that of Adler (of "a": 0x00620062).
TEST(ZlibStream, HasTheHeaderAndTheSumOfItsStandard) {
  const auto stream = zlib_stream("a");
  ASSERT_GT(stream.size(), 6U);
  const auto byte = [&](std::size_t place) { return static_cast<unsigned>(static_cast<unsigned char>(stream[place])); };
  EXPECT_EQ((256 * byte(0) + byte(1)) % 31, 0U);
  EXPECT_EQ(byte(0) & 0xfU, 8U);
  EXPECT_EQ(stream.substr(stream.size() - 4), "\x00\x62\x00\x62"s);
  EXPECT_LT(zlib_stream(std::string(100000, 'x')).size(), 1000U);
}

}  // namespace
}  // namespace breccia
