#include "quasistatic/operator/halo_field.hpp"

#include <numeric>

#include "quasistatic/operator/vector_values.hpp"

namespace breccia::quasistatic {
namespace {

Vector<3> affine_motion(const Strain<3>& strain, const Index<3>& node) noexcept {
  return product(strain,
                 Vector<3>{static_cast<double>(node[0]), static_cast<double>(node[1]), static_cast<double>(node[2])});
}

}  // namespace

HaloField::HaloField(const NodeLayout<3>& nodes, int threads) : begin_(nodes.seen_nodes().begin), threads_(threads) {
  const auto& end = nodes.seen_nodes().end;
  for (std::size_t axis = 0; axis < begin_.size(); ++axis) arrays_.nodes[axis] = end[axis] - begin_[axis];
  arrays_.row = static_cast<std::size_t>(arrays_.nodes[0]);
  arrays_.plane = arrays_.row * static_cast<std::size_t>(arrays_.nodes[1]);
  for (auto& component : values_) component.resize(arrays_.plane * static_cast<std::size_t>(arrays_.nodes[2]));
}

template <class Work>
void HaloField::for_planes(const Work& work) const {
#pragma omp parallel for num_threads(threads_)
  for (int plane = 0; plane < arrays_.nodes[2]; ++plane) {
    work(begin_[2] + plane, static_cast<std::size_t>(plane) * arrays_.plane);
  }
}

template <class Work>
void HaloField::for_nodes_of_plane(int third, std::size_t index, const Work& work) const {
  for (int second = begin_[1]; second < begin_[1] + arrays_.nodes[1]; ++second) {
    for (int first = begin_[0]; first < begin_[0] + arrays_.nodes[0]; ++first) {
      work(Index<3>{first, second, third}, index++);
    }
  }
}

/// index_of_node(node, its index here) is the index of the first component of the node among the values.
template <class IndexOf>
void HaloField::read_values(const double* values, const IndexOf& index_of_node, double amount,
                            const Strain<3>& strain) {
  for_planes([&](int third, std::size_t first_index) {
    for_nodes_of_plane(third, first_index, [&](const Index<3>& node, std::size_t index) {
      const auto motion = affine_motion(strain, node);
      const double* of_node = values + index_of_node(node, index);
      for (std::size_t i = 0; i < 3; ++i) values_[i][index] = amount * motion[i] + of_node[i];
    });
  });
}

void HaloField::read(const NodeLayout<3>& nodes, Vec nodal, double amount, const Strain<3>& strain) {
  if (parallel::ranks() == 1) {
    const auto in_nodal = [&](const Index<3>& node, std::size_t) { return nodes.nodal_index_of(node); };
    read_values(ReadValues(nodal).data(), in_nodal, amount, strain);
    return;
  }
  const auto local = nodes.local_copy(nodal);
  const auto in_local = [](const Index<3>&, std::size_t index) { return 3 * index; };
  read_values(ReadValues(local.get()).data(), in_local, amount, strain);
}

void HaloField::sum_up(const NodeLayout<3>& nodes, Vec nodal) const {
  if (parallel::ranks() > 1) {
    const auto local = nodes.local_zeros();
    write(local.get());
    nodes.sum_up(local.get(), nodal);
    return;
  }
  {
    const WriteValues values(nodal);
    // The planes of nodes outside the box, which are images of planes in it, come afterwards.
    const auto& own = nodes.own_nodes();
    const auto is_inside = [&](int third) { return third >= own.begin[2] && third < own.end[2]; };
    for_planes([&](int third, std::size_t first_index) {
      if (is_inside(third)) add_plane(nodes, third, first_index, values.data());
    });
    for (int plane = 0; plane < arrays_.nodes[2]; ++plane) {
      const int third = begin_[2] + plane;
      if (!is_inside(third)) {
        add_plane(nodes, third, static_cast<std::size_t>(plane) * arrays_.plane, values.data());
      }
    }
  }
  nodes.hold(nodal);
}

/// Adds the values of a plane to a nodal vector of a single process.
void HaloField::add_plane(const NodeLayout<3>& nodes, int third, std::size_t first_index, double* nodal) const {
  for_nodes_of_plane(third, first_index, [&](const Index<3>& node, std::size_t index) {
    double* of_node = nodal + nodes.nodal_index_of(node);
    for (std::size_t i = 0; i < 3; ++i) of_node[i] += values_[i][index];
  });
}

/// Writes the values to a local vector.
void HaloField::write(Vec local) const {
  const WriteValues values(local);
  for_planes([&](int, std::size_t first_index) {
    for (std::size_t index = first_index; index < first_index + arrays_.plane; ++index) {
      for (std::size_t i = 0; i < 3; ++i) values.data()[3 * index + i] = values_[i][index];
    }
  });
}

double HaloField::work_on(const Strain<3>& strain) const {
  std::vector<double> works(static_cast<std::size_t>(arrays_.nodes[2]));
  for_planes([&](int third, std::size_t first_index) {
    double work = 0.0;
    for_nodes_of_plane(third, first_index, [&](const Index<3>& node, std::size_t index) {
      const auto motion = affine_motion(strain, node);
      for (std::size_t i = 0; i < 3; ++i) work += motion[i] * values_[i][index];
    });
    works[static_cast<std::size_t>(third - begin_[2])] = work;
  });
  return std::accumulate(works.begin(), works.end(), 0.0);
}

}  // namespace breccia::quasistatic
