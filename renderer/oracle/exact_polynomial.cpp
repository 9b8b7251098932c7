#include "oracle/exact_polynomial.h"

#include <utility>

namespace timeshade::oracle {

Polynomial ExactPolynomial::rounded() const {
    const int n = static_cast<int>(scaled_.size()) - 1;
    Polynomial p = Polynomial::zero(n);
    Real binomial = 1;
    for (int i = 0; i <= n; ++i) {
        p[i] = static_cast<Real>(scaled_[static_cast<std::size_t>(i)].estimate()) / binomial;
        binomial = binomial * static_cast<Real>(n - i) / static_cast<Real>(i + 1);
    }
    return p;
}

int ExactPolynomial::signAt(double u) const {
    // The sum of c_i u^i (1 - u)^(n - i), by powers that grow from both ends.
    const std::size_t n = scaled_.size() - 1;
    const Expansion rest = Expansion::difference(1.0, u);
    std::vector<Expansion> powers{Expansion(1.0)};
    for (std::size_t i = 0; i < n; ++i) powers.push_back(powers.back() * rest);
    Expansion sum, power(1.0);
    for (std::size_t i = 0; i <= n; ++i) {
        sum += scaled_[i] * (power * powers[n - i]);
        power = power * u;
    }
    return sum.sign();
}

ExactPolynomial ExactPolynomial::operator*(const ExactPolynomial& other) const {
    std::vector<Expansion> product(scaled_.size() + other.scaled_.size() - 1);
    for (std::size_t i = 0; i < scaled_.size(); ++i)
        for (std::size_t j = 0; j < other.scaled_.size(); ++j) product[i + j] += scaled_[i] * other.scaled_[j];
    return ExactPolynomial(std::move(product));
}

ExactPolynomial ExactPolynomial::operator*(double factor) const {
    std::vector<Expansion> product;
    for (const Expansion& c : scaled_) product.push_back(c * factor);
    return ExactPolynomial(std::move(product));
}

ExactPolynomial ExactPolynomial::operator+(const ExactPolynomial& other) const {
    ExactPolynomial sum = *this;
    for (std::size_t i = 0; i < scaled_.size(); ++i) sum.scaled_[i] += other.scaled_[i];
    return sum;
}

ExactPolynomial ExactPolynomial::operator-(const ExactPolynomial& other) const {
    ExactPolynomial difference = *this;
    for (std::size_t i = 0; i < scaled_.size(); ++i) difference.scaled_[i] -= other.scaled_[i];
    return difference;
}

ExactWay ExactWay::difference(const glm::dvec3 (&a)[2], const glm::dvec3 (&b)[2]) {
    const auto component = [&](int c) {
        return ExactPolynomial(Expansion::difference(a[0][c], b[0][c]), Expansion::difference(a[1][c], b[1][c]));
    };
    return {component(0), component(1), component(2)};
}

ExactWay ExactWay::of(const glm::dvec3 (&a)[2]) {
    const glm::dvec3 origin[2] = {glm::dvec3(0.0), glm::dvec3(0.0)};
    return difference(a, origin);
}

ExactPolynomial determinant(const ExactWay& a, const ExactWay& b, const ExactWay& c) {
    return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
}

}  // namespace timeshade::oracle
