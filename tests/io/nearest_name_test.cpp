#include "io/nearest_name.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace breccia {
namespace {

const std::vector<std::string> keys{"filler", "packing", "matrix", "box", "cells", "from", "to"};

TEST(NearestName, FindsTheIntendedName) {
  EXPECT_EQ(nearest_name("filer", keys), "filler");
  EXPECT_EQ(nearest_name("Matrix", keys), "matrix");
  EXPECT_EQ(nearest_name("pakcing", keys), "packing");
  EXPECT_EQ(nearest_name("cell", keys), "cells");
  EXPECT_EQ(nearest_name("form", keys), "from");
}

TEST(NearestName, IsSilentWhenNothingIsNear) {
  EXPECT_EQ(nearest_name("temperature", keys), std::nullopt);
  EXPECT_EQ(nearest_name("x", {}), std::nullopt);
}

TEST(NearestName, SuggestionFallsBackToAllKnownNames) {
  EXPECT_EQ(suggestion("bx", keys), ", did you mean \"box\"?");
  EXPECT_EQ(suggestion("temperature", std::vector<std::string>{"box", "cells"}), "; known: \"box\", \"cells\"");
  EXPECT_EQ(suggestion("temperature", {}), "");
}

}  // namespace
}  // namespace breccia
