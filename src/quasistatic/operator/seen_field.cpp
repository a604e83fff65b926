#include "operator/seen_field.hpp"

#include <numeric>

#include "operator/vector_values.hpp"

namespace breccia::quasistatic {
namespace {

Vector<3> affine_motion(const Strain<3>& strain, const Index<3>& node) noexcept {
  return product(strain,
                 Vector<3>{static_cast<double>(node[0]), static_cast<double>(node[1]), static_cast<double>(node[2])});
}

}  // namespace

SeenField::SeenField(const NodeLayout<3>& nodes, int threads) : begin_(nodes.seen_nodes().begin), threads_(threads) {
  const auto& end = nodes.seen_nodes().end;
  for (std::size_t axis = 0; axis < begin_.size(); ++axis) arrays_.nodes[axis] = end[axis] - begin_[axis];
  arrays_.row = static_cast<std::size_t>(arrays_.nodes[0]);
  arrays_.plane = arrays_.row * static_cast<std::size_t>(arrays_.nodes[1]);
  for (auto& component : values_) component.resize(arrays_.plane * static_cast<std::size_t>(arrays_.nodes[2]));
}

template <class Work>
void SeenField::for_planes(const Work& work) const {
#pragma omp parallel for num_threads(threads_)
  for (int plane = 0; plane < arrays_.nodes[2]; ++plane) {
    work(begin_[2] + plane, static_cast<std::size_t>(plane) * arrays_.plane);
  }
}

template <class Work>
void SeenField::for_nodes_of_plane(int third, std::size_t place, const Work& work) const {
  for (int second = begin_[1]; second < begin_[1] + arrays_.nodes[1]; ++second) {
    for (int first = begin_[0]; first < begin_[0] + arrays_.nodes[0]; ++first) {
      work(Index<3>{first, second, third}, place++);
    }
  }
}

void SeenField::read(Vec local, double amount, const Strain<3>& strain) {
  const ReadValues values(local);
  for_planes([&](int third, std::size_t first_place) {
    for_nodes_of_plane(third, first_place, [&](const Index<3>& node, std::size_t place) {
      const auto motion = affine_motion(strain, node);
      for (std::size_t i = 0; i < 3; ++i) values_[i][place] = amount * motion[i] + values.data()[3 * place + i];
    });
  });
}

void SeenField::write(Vec local) const {
  const WriteValues values(local);
  for_planes([&](int, std::size_t first_place) {
    for (std::size_t place = first_place; place < first_place + arrays_.plane; ++place) {
      for (std::size_t i = 0; i < 3; ++i) values.data()[3 * place + i] = values_[i][place];
    }
  });
}

double SeenField::work_on(const Strain<3>& strain) const {
  std::vector<double> works(static_cast<std::size_t>(arrays_.nodes[2]));
  for_planes([&](int third, std::size_t first_place) {
    double work = 0.0;
    for_nodes_of_plane(third, first_place, [&](const Index<3>& node, std::size_t place) {
      const auto motion = affine_motion(strain, node);
      for (std::size_t i = 0; i < 3; ++i) work += motion[i] * values_[i][place];
    });
    works[static_cast<std::size_t>(third - begin_[2])] = work;
  });
  return std::accumulate(works.begin(), works.end(), 0.0);
}

}  // namespace breccia::quasistatic
