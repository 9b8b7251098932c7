#pragma once

#include <array>
#include <initializer_list>
#include <vector>

#include <glm/glm.hpp>

namespace timeshade::oracle {

/// What polynomials are computed in: 64 bits where the processor has them, at least those of a double.
using Real = long double;

/// A polynomial over [0, 1] in Bernstein form: the sum of c[i] times the i-th Bernstein polynomial of its degree. It
/// lies between its least and its greatest coefficient, and begins and ends with the first and the last.
class Polynomial {
  public:
    static constexpr int mostDegree = 12;

    Polynomial() = default;  ///< zero, of degree 0
    Polynomial(std::initializer_list<Real> coefficients);
    static Polynomial zero(int degree);

    int degree() const { return degree_; }
    Real& operator[](int i) { return c_[static_cast<std::size_t>(i)]; }
    Real operator[](int i) const { return c_[static_cast<std::size_t>(i)]; }
    Real at(Real t) const;  ///< de Casteljau: error at most 3 degree epsilon times the greatest magnitude
    Real largest() const;   ///< magnitude of a coefficient
    Real least() const;
    Real greatest() const;
    Polynomial elevated(int degree) const;  ///< the same polynomial, as one of a degree not lower

  private:
    int degree_ = 0;
    std::array<Real, mostDegree + 1> c_{};
};

/// Degrees add up to at most Polynomial::mostDegree. Coefficients are exactly opposite where a factor's are.
Polynomial operator*(const Polynomial& a, const Polynomial& b);
Polynomial operator*(Real factor, const Polynomial& a);
/// Of one degree.
Polynomial operator+(const Polynomial& a, const Polynomial& b);
Polynomial operator-(const Polynomial& a, const Polynomial& b);

/// Three polynomials of one degree.
struct VectorPolynomial {
    Polynomial x, y, z;
    /// The straight way from one point to another.
    static VectorPolynomial between(const glm::tvec3<Real>& open, const glm::tvec3<Real>& close);
    glm::tvec3<Real> at(Real t) const { return {x.at(t), y.at(t), z.at(t)}; }
    Real largest() const;
};

VectorPolynomial operator+(const VectorPolynomial& a, const VectorPolynomial& b);
VectorPolynomial operator-(const VectorPolynomial& a, const VectorPolynomial& b);
VectorPolynomial operator*(const Polynomial& factor, const VectorPolynomial& a);
Polynomial dot(const VectorPolynomial& a, const VectorPolynomial& b);
VectorPolynomial cross(const VectorPolynomial& a, const VectorPolynomial& b);

/// Adds times to `times` between any two of which, and outside all, the polynomial does not change its sign: its roots
/// in [0, 1], by Descartes' rule of signs in Bernstein form and halving. Coefficients not greater than `noise` say
/// nothing: where a part of [0, 1] has only such, near to a root of two or more, its ends are added; if all of [0, 1]
/// has, nothing is. Exactly the same times for the polynomial with opposite coefficients. In no order.
void addRoots(const Polynomial& polynomial, Real noise, std::vector<double>& times);

}  // namespace timeshade::oracle
