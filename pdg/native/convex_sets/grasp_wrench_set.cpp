#include "grasp_wrench_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>

#include "vectors.hpp"

namespace pdg {
namespace {

using View = std::span<const double>;

View column(const ContactWrenches& w, const std::size_t contact, const std::size_t j) {
  const std::size_t first = (contact * (1 + w.axes) + j) * w.dimension;
  return std::span(w.columns).subspan(first, w.dimension);
}

void check(const ContactWrenches& w) {
  if (w.contacts == 0 || w.dimension == 0 ||
      w.columns.size() != w.contacts * (1 + w.axes) * w.dimension) {
    throw std::invalid_argument("contact wrenches of the wrong size");
  }
}

// |c| + sum |M| of one contact.
std::vector<double> contact_magnitude(const ContactWrenches& w, const std::size_t contact) {
  std::vector<double> magnitude(w.dimension);
  for (std::size_t j = 0; j <= w.axes; ++j) {
    const View c = column(w, contact, j);
    for (std::size_t i = 0; i < c.size(); ++i) magnitude[i] += std::abs(c[i]);
  }
  return magnitude;
}

// Over contacts: their largest (a union) or their sum.
template <class Each>
std::vector<double> over_contacts(const ContactWrenches& w, const ForceNorm norm,
                                  const Each& each) {
  std::vector<double> total(w.dimension);
  for (std::size_t k = 0; k < w.contacts; ++k) {
    const std::vector<double> one = each(k);
    for (std::size_t i = 0; i < total.size(); ++i) {
      total[i] = norm == ForceNorm::kSum ? std::max(total[i], one[i]) : total[i] + one[i];
    }
  }
  return total;
}

std::vector<double> magnitude_of(const ContactWrenches& w, const ForceNorm norm) {
  return over_contacts(w, norm, [&](const std::size_t k) { return contact_magnitude(w, k); });
}

// The rounding error of each contact's ellipsoid, and of the sum over contacts. A wrong choice
// between contacts, or between a contact and the origin, still gives a point of the set, and a
// value off by no more.
std::vector<double> error_of(const ContactWrenches& w, const ForceNorm norm) {
  std::vector<double> error = over_contacts(w, norm, [&](const std::size_t k) {
    return rounding_error(contact_magnitude(w, k), w.dimension + w.axes);
  });
  if (norm == ForceNorm::kLargest) {
    const std::vector<double> sums = rounding_error(magnitude_of(w, norm), w.contacts);
    for (std::size_t i = 0; i < error.size(); ++i) error[i] += sums[i];
  }
  return error;
}

class GraspWrenchSet final : public ConvexSet {
 public:
  GraspWrenchSet(ContactWrenches wrenches, const ForceNorm norm, const bool idle)
      : ConvexSet(magnitude_of(wrenches, norm), error_of(wrenches, norm)),
        w_(std::move(wrenches)),
        norm_(norm),
        idle_(idle) {}

  [[nodiscard]] double value(const View u) const override {
    if (norm_ == ForceNorm::kSum) return strongest(u).value;
    double sum = 0.0;
    for (std::size_t k = 0; k < w_.contacts; ++k) {
      const double h = contact_value(u, k);
      if (h > 0.0 || !idle_) sum += h;
    }
    return sum;
  }

  double add_support(const View u, const std::span<double> point) const override {
    if (norm_ == ForceNorm::kSum) {
      const Strongest found = strongest(u);
      if (found.pushes) add_contact_point(u, found.contact, point);
      return found.value;
    }
    double sum = 0.0;
    for (std::size_t k = 0; k < w_.contacts; ++k) {
      const double h = contact_value(u, k);
      if (h <= 0.0 && idle_) continue;
      sum += h;
      add_contact_point(u, k, point);
    }
    return sum;
  }

 private:
  struct Strongest {
    std::size_t contact = 0;
    double value = 0.0;
    bool pushes = false;  // false: the origin is the support point
  };

  [[nodiscard]] Strongest strongest(const View u) const {
    Strongest found{0, idle_ ? 0.0 : -std::numeric_limits<double>::infinity(), false};
    for (std::size_t k = 0; k < w_.contacts; ++k) {
      const double h = contact_value(u, k);
      if (h > found.value) found = {k, h, true};
    }
    return found;
  }

  // |M^T u|.
  [[nodiscard]] double radius(const View u, const std::size_t contact) const {
    double square = 0.0;
    for (std::size_t j = 1; j <= w_.axes; ++j) {
      const double v = dot(column(w_, contact, j), u);
      square += v * v;
    }
    return std::sqrt(square);
  }

  [[nodiscard]] double contact_value(const View u, const std::size_t contact) const {
    return dot(column(w_, contact, 0), u) + radius(u, contact);
  }

  // Adds c + M M^T u / |M^T u|.
  void add_contact_point(const View u, const std::size_t contact,
                         const std::span<double> point) const {
    const double rho = radius(u, contact);
    const double divisor = rho > 0.0 ? rho : 1.0;
    const View centre = column(w_, contact, 0);
    for (std::size_t i = 0; i < centre.size(); ++i) point[i] += centre[i];
    for (std::size_t j = 1; j <= w_.axes; ++j) {
      const View axis = column(w_, contact, j);
      const double share = dot(axis, u) / divisor;
      for (std::size_t i = 0; i < axis.size(); ++i) point[i] += share * axis[i];
    }
  }

  ContactWrenches w_;
  ForceNorm norm_;
  bool idle_;
};

}  // namespace

SetPointer grasp_wrench_set(ContactWrenches wrenches, const ForceNorm norm, const bool idle) {
  check(wrenches);
  return std::make_shared<GraspWrenchSet>(std::move(wrenches), norm, idle);
}

}  // namespace pdg
