#include "oracle/polynomial.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace timeshade::oracle {

namespace {

constexpr int count = Polynomial::mostDegree + 1;
using Row = std::array<Real, count>;

/// Binomial coefficients: row n, column k.
constexpr std::array<Row, count> binomials = [] {
    std::array<Row, count> rows{};
    for (std::size_t n = 0; n < count; ++n) {
        rows[n][0] = rows[n][n] = 1;
        for (std::size_t k = 1; k < n; ++k) rows[n][k] = rows[n - 1][k - 1] + rows[n - 1][k];
    }
    return rows;
}();

const Row& binomialsOf(int n) { return binomials[static_cast<std::size_t>(n)]; }

/// Both halves of a polynomial, each over [0, 1] again.
void halve(const Polynomial& p, Polynomial& left, Polynomial& right) {
    const int n = p.degree();
    left = right = p;
    for (int round = 1; round <= n; ++round) {
        for (int i = 0; i <= n - round; ++i) right[i] = (right[i] + right[i + 1]) / 2;
        left[round] = right[0];
    }
}

int signOf(Real value) { return value > 0 ? 1 : (value < 0 ? -1 : 0); }

int changesOfSign(const Polynomial& p) {
    int changes = 0, before = 0;
    for (int i = 0; i <= p.degree(); ++i) {
        const int sign = signOf(p[i]);
        if (sign == 0) continue;
        changes += before != 0 && sign != before ? 1 : 0;
        before = sign;
    }
    return changes;
}

/// Where p changes its sign, if it does so once.
double onlyChange(const Polynomial& p, double low, double high) {
    int begin = 0;
    for (int i = 0; begin == 0; ++i) begin = signOf(p[i]);
    Real a = 0, b = 1;
    // As near as a double can tell, whichever half of [0, 1] it is in.
    while (b - a > std::ldexp(static_cast<Real>(1), -56)) {
        const Real middle = (a + b) / 2;
        const int sign = signOf(p.at(middle));
        if (sign == 0) {
            a = b = middle;
        } else {
            (sign == begin ? a : b) = middle;
        }
    }
    return low + static_cast<double>((a + b) / 2) * (high - low);
}

void isolate(const Polynomial& p, double low, double high, Real noise, std::vector<double>& times) {
    if (p.largest() <= noise || high - low < 0x1p-48) {
        times.insert(times.end(), {low, high});
        return;
    }
    const int changes = changesOfSign(p);
    if (changes == 0) return;
    if (changes == 1) {
        times.push_back(onlyChange(p, low, high));
        return;
    }
    Polynomial left, right;
    halve(p, left, right);
    const double middle = 0.5 * (low + high);
    if (right[0] == 0) times.push_back(middle);
    isolate(left, low, middle, noise, times);
    isolate(right, middle, high, noise, times);
}

}  // namespace

Polynomial::Polynomial(std::initializer_list<Real> coefficients) : degree_(static_cast<int>(coefficients.size()) - 1) {
    std::copy(coefficients.begin(), coefficients.end(), c_.begin());
}

Polynomial Polynomial::zero(int degree) {
    CHECK_LE(degree, mostDegree);
    Polynomial p;
    p.degree_ = degree;
    return p;
}

Real Polynomial::at(Real t) const {
    auto c = c_;
    for (int n = degree_; n > 0; --n)
        for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) c[i] += t * (c[i + 1] - c[i]);
    return c[0];
}

Real Polynomial::least() const { return *std::min_element(c_.begin(), c_.begin() + degree_ + 1); }
Real Polynomial::greatest() const { return *std::max_element(c_.begin(), c_.begin() + degree_ + 1); }
Real Polynomial::largest() const { return std::max(greatest(), -least()); }

Polynomial Polynomial::elevated(int degree) const {
    Polynomial one = zero(degree - degree_);
    for (int i = 0; i <= one.degree_; ++i) one[i] = 1;
    return *this * one;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    const int m = a.degree(), n = b.degree();
    Polynomial product = Polynomial::zero(m + n);
    const Row &ofA = binomialsOf(m), &ofB = binomialsOf(n), &ofProduct = binomialsOf(m + n);
    Row scaledB;
    for (std::size_t j = 0; j <= static_cast<std::size_t>(n); ++j) scaledB[j] = ofB[j] * b[static_cast<int>(j)];
    for (int i = 0; i <= m; ++i) {
        const Real scaled = ofA[static_cast<std::size_t>(i)] * a[i];
        for (int j = 0; j <= n; ++j) product[i + j] += scaled * scaledB[static_cast<std::size_t>(j)];
    }
    for (int k = 1; k < m + n; ++k) product[k] /= ofProduct[static_cast<std::size_t>(k)];
    return product;
}

Polynomial operator*(Real factor, const Polynomial& a) {
    Polynomial product = a;
    for (int i = 0; i <= a.degree(); ++i) product[i] *= factor;
    return product;
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
    CHECK_EQ(a.degree(), b.degree());
    Polynomial sum = a;
    for (int i = 0; i <= a.degree(); ++i) sum[i] += b[i];
    return sum;
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) {
    CHECK_EQ(a.degree(), b.degree());
    Polynomial difference = a;
    for (int i = 0; i <= a.degree(); ++i) difference[i] -= b[i];
    return difference;
}

VectorPolynomial VectorPolynomial::between(const glm::tvec3<Real>& open, const glm::tvec3<Real>& close) {
    return {{open.x, close.x}, {open.y, close.y}, {open.z, close.z}};
}

Real VectorPolynomial::largest() const { return std::max({x.largest(), y.largest(), z.largest()}); }

VectorPolynomial operator+(const VectorPolynomial& a, const VectorPolynomial& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

VectorPolynomial operator-(const VectorPolynomial& a, const VectorPolynomial& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

VectorPolynomial operator*(const Polynomial& factor, const VectorPolynomial& a) {
    return {factor * a.x, factor * a.y, factor * a.z};
}

Polynomial dot(const VectorPolynomial& a, const VectorPolynomial& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

VectorPolynomial cross(const VectorPolynomial& a, const VectorPolynomial& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

void addRoots(const Polynomial& polynomial, Real noise, std::vector<double>& times) {
    if (polynomial.largest() <= noise) return;
    isolate(polynomial, 0.0, 1.0, noise, times);
}

}  // namespace timeshade::oracle
