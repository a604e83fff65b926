#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "breccia/probability/distribution.hpp"
#include "breccia/words.hpp"

namespace breccia {

/// A number that describes a material. The elastic constants are those of a material that does not relax; one of them
/// that is unknown alone leaves the other of its pair as it is: bulk with shear, Young's modulus with Poisson's ratio.
/// The moduli of a material that relaxes change in shear; its bulk modulus changes by the same factor where Poisson's
/// ratio does not depend on time, and stays as it is otherwise.
enum class MaterialNumber {
  shear,        ///< shear modulus [Pa]
  bulk,         ///< bulk modulus [Pa]
  young,        ///< Young's modulus [Pa]
  poisson,      ///< Poisson's ratio [-]
  equilibrium,  ///< equilibrium shear modulus of a material that relaxes [Pa]
  modulus,      ///< factor of the moduli of a material that relaxes [-]
  times,        ///< factor of all relaxation times [-]
  c1,           ///< constant c1 of the law of Williams, Landel and Ferry [-]
  c2            ///< constant c2 of that law [K]
};

template <>
inline constexpr auto words<MaterialNumber> = std::to_array<Word<MaterialNumber>>({{"shear", MaterialNumber::shear},
                                                                                   {"bulk", MaterialNumber::bulk},
                                                                                   {"young", MaterialNumber::young},
                                                                                   {"poisson", MaterialNumber::poisson},
                                                                                   {"equilibrium",
                                                                                    MaterialNumber::equilibrium},
                                                                                   {"modulus", MaterialNumber::modulus},
                                                                                   {"times", MaterialNumber::times},
                                                                                   {"c1", MaterialNumber::c1},
                                                                                   {"c2", MaterialNumber::c2}});

/// The SI unit of a number: "Pa", "K" or, of one without a unit, "".
std::string_view unit_of(MaterialNumber number);

/// A number of a material that is not known, with what is known of it.
struct UnknownNumber {
  std::string material;
  MaterialNumber number = MaterialNumber::shear;
  Distribution prior = {};
};

/// The shear relaxation spectrum of a material that is not known: a modulus for each of these relaxation times [s],
/// which are equally spaced in their logarithm. A priori the geometric mean of the moduli has the distribution `term`,
/// and the curvature of their logarithms is normal with a deviation that the data choose. An equilibrium modulus stays
/// as it is, unless it is unknown, too.
struct UnknownSpectrum {
  std::string material;
  std::vector<double> times = {};
  LogNormal term = {};
};

using Unknown = std::variant<UnknownNumber, UnknownSpectrum>;

/// The name of an unknown: "hmx.shear", "binder.spectrum".
std::string name_of(const Unknown& unknown);
/// The name of the material that an unknown changes.
const std::string& material_of(const Unknown& unknown);
/// What is known of the unknown number, or of each modulus of the unknown spectrum.
Distribution prior_of(const Unknown& unknown);
/// The SI unit of the unknown number, or of each modulus of the unknown spectrum.
std::string_view unit_of(const Unknown& unknown);

}  // namespace breccia
