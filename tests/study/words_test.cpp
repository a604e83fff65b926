#include "breccia/words.hpp"

#include <array>
#include <set>
#include <string>
#include <type_traits>

#include <gtest/gtest.h>

#include "breccia/study/tests.hpp"

#include "dynamics/dynamic_problem.hpp"

namespace breccia {
namespace {

template <class Enum>
class Words : public testing::Test {};
using Enumerations =
    testing::Types<Load, Boundary, Method, Volumetric, Solver, SampledRange, LinearMethod, Formulation, Start>;
struct EnumerationNames {
  template <class Enum>
  static std::string GetName(int number) {  // NOLINT(readability-identifier-naming): as GoogleTest calls it
    constexpr std::array names = {"Load",         "Boundary",     "Method",      "Volumetric", "Solver",
                                  "SampledRange", "LinearMethod", "Formulation", "Start"};
    return names.at(static_cast<std::size_t>(number));
  }
};
TYPED_TEST_SUITE(Words, Enumerations, EnumerationNames);

TYPED_TEST(Words, LeadThereAndBack) {
  std::set<std::string> names;
  for (const auto& [word, value] : words<TypeParam>) {
    EXPECT_EQ(name_of(value), word);
    EXPECT_EQ(value_named<TypeParam>(word), value);
    EXPECT_TRUE(names.insert(std::string(word)).second) << word << " stands twice";
  }
  EXPECT_EQ(value_named<TypeParam>("none of them"), std::nullopt);
}

}  // namespace
}  // namespace breccia
