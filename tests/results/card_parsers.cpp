#include "card_parsers.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace breccia::test {
namespace {

std::vector<std::string> lines_of_card(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> split_at(const std::string& line, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(line);
  for (std::string part; std::getline(stream, part, separator);) {
    const auto first = part.find_first_not_of(' ');
    parts.push_back(first == std::string::npos ? "" : part.substr(first, part.find_last_not_of(' ') - first + 1));
  }
  return parts;
}

void require(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error("the card: " + what);
}

/// Bulk and shear modulus of Young's modulus and Poisson's ratio.
double bulk_of(double young, double poisson) {
  return young / (3.0 * (1.0 - 2.0 * poisson));
}
double shear_of(double young, double poisson) {
  return young / (2.0 * (1.0 + poisson));
}

/// The series with the equilibrium modulus M_0 (1 - sum of shares) and the terms M_0 share_i.
PronySeries from_shares(double instantaneous, const std::vector<std::pair<double, double>>& shares_and_times) {
  double rest = 1.0;
  std::vector<MaxwellTerm> terms;
  for (const auto& [share, time] : shares_and_times) {
    rest -= share;
    if (share > 0.0) terms.push_back({time, instantaneous * share});
  }
  require(rest > -1e-12, "the shares add up to more than one");
  return {instantaneous * std::max(rest, 0.0), terms};
}

/// The value behind the last colon or before a comma in a comment such as "% density: 1.5".
double value_behind(const std::string& line, const std::string& name) {
  const auto at = line.find(name);
  require(at != std::string::npos, "no " + name);
  return std::stod(line.substr(at + name.size()));
}

}  // namespace

ParsedCard parse_abaqus(const std::string& text) {
  ParsedCard card;
  std::string keyword;
  double shear = 0.0, bulk = 0.0;
  std::vector<std::pair<double, double>> of_shear, of_bulk;
  for (const auto& line : lines_of_card(text)) {
    if (line.rfind("**", 0) == 0) continue;
    if (line.rfind('*', 0) == 0) {
      keyword = line;
      if (line.rfind("*Material, name=", 0) == 0) card.name = line.substr(16);
      continue;
    }
    const auto fields = split_at(line, ',');
    if (keyword == "*Density") {
      card.density = std::stod(fields.at(0));
    } else if (keyword == "*Elastic, moduli=INSTANTANEOUS") {
      shear = shear_of(std::stod(fields.at(0)), std::stod(fields.at(1)));
      bulk = bulk_of(std::stod(fields.at(0)), std::stod(fields.at(1)));
    } else if (keyword == "*Viscoelastic, time=PRONY") {
      require(fields.size() == 3, "three numbers a term");
      of_shear.emplace_back(std::stod(fields[0]), std::stod(fields[2]));
      of_bulk.emplace_back(std::stod(fields[1]), std::stod(fields[2]));
    } else if (keyword == "*Trs, definition=WLF") {
      card.shift = {std::stod(fields.at(1)), std::stod(fields.at(2)), std::stod(fields.at(0))};
    } else {
      require(false, "unknown keyword " + keyword);
    }
  }
  card.shear = from_shares(shear, of_shear);
  card.bulk = from_shares(bulk, of_bulk);
  return card;
}

ParsedCard parse_ansys(const std::string& text) {
  ParsedCard card;
  double young = 0.0, poisson = 0.0;
  std::string table;
  std::map<std::string, std::size_t> pairs;
  std::map<std::string, std::map<int, double>> constants;
  for (const auto& line : lines_of_card(text)) {
    if (line.rfind('!', 0) == 0) continue;
    const auto fields = split_at(line, ',');
    if (fields[0] == "MP") {
      const double value = std::stod(fields.at(3));
      if (fields[1] == "DENS") card.density = value;
      if (fields[1] == "EX") young = value;
      if (fields[1] == "NUXY") poisson = value;
    } else if (fields[0] == "TB") {
      table = fields.at(5);
      pairs[table] = std::stoul(fields.at(4));
    } else {
      require(fields[0] == "TBDATA" && fields.size() <= 8, "unknown command " + line);
      for (std::size_t i = 2; i < fields.size(); ++i) {
        constants[table][std::stoi(fields[1]) + static_cast<int>(i) - 2] = std::stod(fields[i]);
      }
    }
  }
  const auto series = [&](const std::string& label, double instantaneous) {
    std::vector<std::pair<double, double>> shares;
    const auto& of_table = constants[label];
    require(of_table.size() == 2 * pairs[label], "as many pairs as TB announces");
    for (int i = 1; i < static_cast<int>(of_table.size()); i += 2)
      shares.emplace_back(of_table.at(i), of_table.at(i + 1));
    return from_shares(instantaneous, shares);
  };
  card.shear = series("SHEAR", shear_of(young, poisson));
  card.bulk = series("BULK", bulk_of(young, poisson));
  if (constants.count("WLF") > 0) {
    const auto& law = constants.at("WLF");
    card.shift = {law.at(2), law.at(3), law.at(1)};
  }
  return card;
}

ParsedCard parse_ls_dyna(const std::string& text) {
  std::vector<std::string> lines;
  for (const auto& line : lines_of_card(text)) {
    if (line.rfind('$', 0) != 0) lines.push_back(line);
  }
  require(lines.at(0) == "*MAT_GENERAL_VISCOELASTIC_TITLE", "the keyword");
  const auto field = [](const std::string& line, std::size_t number) {
    constexpr std::size_t width = 10;
    return line.size() < (number + 1) * width ? 0.0 : std::stod(line.substr(number * width, width));
  };
  ParsedCard card;
  card.name = lines.at(1);
  card.density = field(lines.at(2), 1);
  require(lines.at(3).empty(), "a blank second card");
  constexpr std::size_t most = 18;
  require(lines.size() - 4 <= most, "at most 18 terms");
  double shear = 0.0, bulk = 0.0;
  std::vector<MaxwellTerm> of_shear, of_bulk;
  for (std::size_t i = 4; i < lines.size(); ++i) {
    const auto add = [&](double modulus, double decay, double& equilibrium, std::vector<MaxwellTerm>& terms) {
      if (decay == 0.0) {
        equilibrium += modulus;
      } else if (modulus > 0.0) {
        terms.push_back({1.0 / decay, modulus});
      }
    };
    add(field(lines[i], 0), field(lines[i], 1), shear, of_shear);
    add(field(lines[i], 2), field(lines[i], 3), bulk, of_bulk);
  }
  card.shear = PronySeries(shear, of_shear);
  card.bulk = bulk == 0.0 && of_bulk.empty() ? PronySeries(field(lines.at(2), 2)) : PronySeries(bulk, of_bulk);
  return card;
}

ParsedCard parse_openradioss(const std::string& text) {
  std::vector<std::string> lines;
  for (const auto& line : lines_of_card(text)) {
    if (line.rfind('#', 0) != 0) lines.push_back(line);
  }
  const auto field = [](const std::string& line, std::size_t begin, std::size_t width) {
    return line.size() < begin + width ? 0.0 : std::stod(line.substr(begin, width));
  };
  constexpr std::size_t wide = 20, narrow = 10;
  require(lines.at(0) == "/MAT/LAW42/1", "the keyword of the law");
  ParsedCard card;
  card.name = lines.at(1);
  card.density = field(lines.at(2), 0, wide);
  const double ratio = field(lines.at(3), 0, wide);
  require(lines.at(3).size() == 5 * wide, "a line of a hundred columns");
  require(lines.at(3).substr(2 * wide, narrow) == std::string(narrow, ' '), "ten empty columns");
  require(lines.at(5).empty() && lines.at(7).empty(), "the blank lines");
  // Ogden's solid: the shear modulus is half of the sum of mu alpha, K = 2 G (1 + nu) / (3 (1 - 2 nu)).
  double shear = 0.0;
  for (std::size_t i = 0; i < 5; ++i)
    shear += 0.5 * field(lines.at(4), i * wide, wide) * field(lines.at(6), i * wide, wide);
  const double bulk = 2.0 * shear * (1.0 + ratio) / (3.0 * (1.0 - 2.0 * ratio));
  std::vector<MaxwellTerm> of_shear, of_bulk;
  if (lines.size() > 8) {
    require(lines.at(8) == "/VISC/PRONY/1", "the keyword of the terms");
    require(static_cast<std::size_t>(field(lines.at(9), 0, narrow)) == lines.size() - 10, "the number of terms");
    for (std::size_t i = 10; i < lines.size(); ++i) {
      const auto add = [&](std::size_t place, std::vector<MaxwellTerm>& terms) {
        const double modulus = field(lines[i], place * wide, wide);
        if (modulus > 0.0) terms.push_back({1.0 / field(lines[i], (place + 1) * wide, wide), modulus});
      };
      add(0, of_shear);
      add(2, of_bulk);
    }
  }
  card.shear = PronySeries(shear, of_shear);
  card.bulk = PronySeries(bulk, of_bulk);
  return card;
}

ParsedCard parse_comsol(const std::string& text) {
  ParsedCard card;
  double shear = 0.0, bulk = 0.0;
  std::vector<MaxwellTerm> of_shear, of_bulk;
  const auto term = [](const std::string& numbers) {
    std::istringstream stream(numbers);
    MaxwellTerm read{};
    stream >> read.modulus >> read.relaxation_time;
    require(!stream.fail(), "a modulus and a time");
    return read;
  };
  for (const auto& line : lines_of_card(text)) {
    if (line.rfind("% name: ", 0) == 0) card.name = line.substr(8);
    if (line.rfind("% density: ", 0) == 0) card.density = value_behind(line, ": ");
    if (line.rfind("% long-term shear modulus G: ", 0) == 0) shear = value_behind(line, "G: ");
    if (line.rfind("% long-term bulk modulus K: ", 0) == 0) bulk = value_behind(line, "K: ");
    if (line.rfind("% volumetric branch ", 0) == 0) of_bulk.push_back(term(line.substr(line.find(':') + 1)));
    if (line.rfind("% shift function ", 0) == 0) {
      card.shift = {value_behind(line, "C1 "), value_behind(line, "C2 "), value_behind(line, "T_ref ")};
    }
    if (line.rfind('%', 0) == 0) continue;
    require(std::stoul(line) == of_shear.size() + 1, "branches in order");
    of_shear.push_back(term(line.substr(line.find(' '))));
  }
  card.shear = PronySeries(shear, of_shear);
  card.bulk = PronySeries(bulk, of_bulk);
  return card;
}

ParsedCard parse_moose(const std::string& text) {
  ParsedCard card;
  std::map<std::string, std::string> parameters;
  for (const auto& line : lines_of_card(text)) {
    if (line.rfind("  [", 0) == 0 && card.name.empty()) card.name = line.substr(3, line.size() - 4);
    const auto sign = line.find(" = ");
    if (line.rfind('#', 0) != 0 && sign != std::string::npos) {
      parameters.emplace(line.substr(line.find_first_not_of(' '), sign - line.find_first_not_of(' ')),
                         line.substr(sign + 3));
    }
  }
  card.density = std::stod(parameters.at("prop_values"));
  const bool is_elastic = parameters.at("type") == "ComputeIsotropicElasticityTensor";
  const double young = std::stod(parameters.at(is_elastic ? "youngs_modulus" : "young_modulus"));
  const double poisson = std::stod(parameters.at("poisson_ratio"));
  // The stiffness of the first spring is the instantaneous stiffness minus that of the branches.
  double shear = shear_of(young, poisson), bulk = bulk_of(young, poisson);
  std::vector<MaxwellTerm> of_shear, of_bulk;
  const auto numbers = [&](const std::string& name) {
    std::vector<double> list;
    if (is_elastic) return list;
    const auto& quoted = parameters.at(name);
    require(quoted.front() == '\'' && quoted.back() == '\'', "a list in quotes");
    std::istringstream stream(quoted.substr(1, quoted.size() - 2));
    for (double number = 0.0; stream >> number;) list.push_back(number);
    return list;
  };
  const auto moduli = numbers("creep_modulus"), times = numbers("creep_viscosity"), ratios = numbers("creep_ratio");
  require(moduli.size() == times.size() && moduli.size() == ratios.size(), "lists of the same length");
  for (std::size_t i = 0; i < moduli.size(); ++i) {
    of_shear.push_back({times[i], shear_of(moduli[i], ratios[i])});
    of_bulk.push_back({times[i], bulk_of(moduli[i], ratios[i])});
    shear -= of_shear.back().modulus;
    bulk -= of_bulk.back().modulus;
  }
  card.shear = PronySeries(shear, of_shear);
  card.bulk = PronySeries(bulk, of_bulk);
  return card;
}

ParsedCard parse_csv_card(const std::string& text) {
  ParsedCard card;
  double shear = 0.0, bulk = 0.0, shares = 0.0;
  std::vector<MaxwellTerm> of_shear, of_bulk;
  bool is_table = false;
  for (const auto& line : lines_of_card(text)) {
    if (line.rfind("# name: ", 0) == 0) card.name = line.substr(8);
    if (line.rfind("# density: ", 0) == 0) card.density = value_behind(line, ": ");
    if (line.rfind("# Williams", 0) == 0) {
      card.shift = {value_behind(line, "c1 "), value_behind(line, "c2 "), value_behind(line, "T_ref ")};
    }
    if (line.rfind('#', 0) == 0) continue;
    const auto fields = split_at(line, ',');
    require(fields.size() == 5, "five columns");
    if (!std::exchange(is_table, true)) continue;
    const double time = std::stod(fields[0]);
    shares += std::stod(fields[3]);
    if (std::isinf(time)) {
      shear = std::stod(fields[1]);
      bulk = std::stod(fields[2]);
      continue;
    }
    if (std::stod(fields[1]) > 0.0) of_shear.push_back({time, std::stod(fields[1])});
    if (std::stod(fields[2]) > 0.0) of_bulk.push_back({time, std::stod(fields[2])});
  }
  constexpr double of_twelve_digits = 1e-11;
  require(std::abs(shares - 1.0) < of_twelve_digits, "shares that add up to one");
  card.shear = PronySeries(shear, of_shear);
  card.bulk = PronySeries(bulk, of_bulk);
  return card;
}

ParsedCard parse_card(const std::string& format, const std::string& text) {
  const std::map<std::string, ParsedCard (*)(const std::string&)> parsers = {
      {"abaqus", parse_abaqus}, {"ansys", parse_ansys}, {"ls-dyna", parse_ls_dyna}, {"openradioss", parse_openradioss},
      {"comsol", parse_comsol}, {"moose", parse_moose}, {"csv", parse_csv_card}};
  return parsers.at(format)(text);
}

}  // namespace breccia::test
