#include "packing.hpp"

#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace disc_packings {

Packing read_packing(const std::string& path) {
  std::ifstream file(path);
  Packing packing;
  std::string line;
  while (std::getline(file, line)) {
    if (line.empty() || line.starts_with('#') || line.starts_with("x,")) continue;
    double x = 0.0;
    double y = 0.0;
    double diameter = 0.0;
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf", &x, &y, &diameter) != 3) {
      throw std::runtime_error(path + ": no disc: " + line);
    }
    packing.push_back({{x, y}, diameter / 2.0});
  }
  if (packing.empty()) throw std::runtime_error(path + ": no discs");
  return packing;
}

double gap(const Disc& one, const Disc& other) {
  return (other.centre - one.centre).norm() - one.radius - other.radius;
}

double neck_radius(const Disc& one, const Disc& other) {
  return 2.0 * one.radius * other.radius / (one.radius + other.radius);
}

}  // namespace disc_packings
