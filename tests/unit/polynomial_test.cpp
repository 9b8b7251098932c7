// Polynomials in Bernstein form, their roots, and the same without rounding.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "oracle/exact_polynomial.h"
#include "oracle/polynomial.h"

namespace timeshade::oracle {
namespace {

constexpr Real rounding = 1e-18;

class Numbers {
  public:
    explicit Numbers(std::uint32_t seed) : random_(seed) {}
    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    glm::dvec3 point() {
        const double x = between(-1, 1), y = between(-1, 1), z = between(-1, 1);
        return {x, y, z};
    }
    Polynomial polynomial(int degree) {
        Polynomial p = Polynomial::zero(degree);
        for (int i = 0; i <= degree; ++i) p[i] = static_cast<Real>(between(-1, 1));
        return p;
    }

  private:
    std::mt19937 random_;
};

/// t less a root.
Polynomial factor(double root) { return {static_cast<Real>(-root), 1 - static_cast<Real>(root)}; }

std::vector<double> rootsOf(const Polynomial& p, Real noise = rounding) {
    std::vector<double> times;
    addRoots(p, noise * p.largest(), times);
    std::sort(times.begin(), times.end());
    return times;
}

TEST(Polynomial, ProductsAndSumsAreThoseOfValues) {
    Numbers numbers(1);
    for (int i = 0; i < 1000; ++i) {
        const Polynomial a = numbers.polynomial(i % 7), b = numbers.polynomial(i % 5), c = numbers.polynomial(i % 7);
        const auto t = static_cast<Real>(numbers.between(0, 1));
        ASSERT_NEAR(static_cast<double>((a * b).at(t) - a.at(t) * b.at(t)), 0.0, 1e-17);
        ASSERT_NEAR(static_cast<double>((a - c).at(t) - (a.at(t) - c.at(t))), 0.0, 1e-17);
        ASSERT_NEAR(static_cast<double>((a + c).at(t) - (a.at(t) + c.at(t))), 0.0, 1e-17);
        ASSERT_NEAR(static_cast<double>(a.elevated(12).at(t) - a.at(t)), 0.0, 1e-17);
        ASSERT_LE(a.at(t), a.greatest());
        ASSERT_GE(a.at(t), a.least());
    }
}

/// A product of linear factors has their roots inside [0, 1], and no others.
TEST(Polynomial, RootsAreThoseOfItsFactors) {
    Numbers numbers(2);
    for (int i = 0; i < 20000; ++i) {
        std::vector<double> inside;
        Polynomial p{static_cast<Real>(i % 2 == 0 ? 1 : -1)};
        for (int degree = 1 + i % 12; p.degree() < degree;) {
            const double root = numbers.between(-0.5, 1.5);
            if (std::any_of(inside.begin(), inside.end(), [&](double r) { return std::abs(r - root) < 0.02; }))
                continue;
            if (root > 0.0 && root < 1.0) inside.push_back(root);
            p = p * factor(root);
        }
        std::sort(inside.begin(), inside.end());
        const std::vector<double> found = rootsOf(p);
        ASSERT_EQ(found.size(), inside.size()) << i;
        // Twelve roots within a unit are as ill-conditioned as roots come.
        for (std::size_t k = 0; k < found.size(); ++k) ASSERT_NEAR(found[k], inside[k], i % 12 < 6 ? 1e-13 : 2e-8);
        ASSERT_EQ(rootsOf(static_cast<Real>(-1) * p), found);
    }
}

/// Between two times that are found, and outside all, the sign does not change.
TEST(Polynomial, SignsChangeNowhereElse) {
    Numbers numbers(3);
    for (int i = 0; i < 3000; ++i) {
        const double root = numbers.between(0.1, 0.9), apart = std::exp2(numbers.between(-40, -2));
        // One or two pairs of roots that are close or equal.
        Polynomial p = factor(root) * factor(i % 3 == 0 ? root : root + apart);
        if (i % 2 == 0) p = p * p;
        p = p * numbers.polynomial(i % 4);
        std::vector<double> cuts = rootsOf(p);
        cuts.insert(cuts.end(), {0.0, 1.0});
        std::sort(cuts.begin(), cuts.end());
        for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
            int before = 0;
            for (int j = 1; j < 50; ++j) {
                const Real value = p.at(static_cast<Real>(cuts[k] + (cuts[k + 1] - cuts[k]) * j / 50.0));
                if (std::abs(value) <= 64 * rounding * p.largest()) continue;
                const int sign = value > 0 ? 1 : -1;
                ASSERT_TRUE(before == 0 || sign == before) << i << ", root " << root << ", apart " << apart;
                before = sign;
            }
        }
    }
}

TEST(Polynomial, DoubleRootsAreCuts) {
    for (const double root : {0.5, 0.3, 0.123456789}) {
        const std::vector<double> cuts = rootsOf(factor(root) * factor(root), 1e-17L);
        ASSERT_FALSE(cuts.empty());
        for (const double cut : cuts) EXPECT_NEAR(cut, root, 1e-8);
        const double apart = 1e-6;
        const std::vector<double> two = rootsOf(factor(root) * factor(root + apart));
        ASSERT_EQ(two.size(), 2u);
        EXPECT_NEAR(two[0], root, 1e-12);
        EXPECT_NEAR(two[1], root + apart, 1e-12);
    }
}

TEST(Polynomial, WhatIsAllNoiseHasNoRoots) {
    EXPECT_TRUE(rootsOf(Polynomial::zero(6)).empty());
    EXPECT_TRUE(rootsOf({1e-20L, -1e-20L, 1e-20L}, 2.0L).empty());
    EXPECT_TRUE(rootsOf({1.0L, 1.0L, 1.0L}).empty());
}

TEST(ExactPolynomial, IsTheSameWithoutRounding) {
    Numbers numbers(5);
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 a[2] = {numbers.point(), numbers.point()}, b[2] = {numbers.point(), numbers.point()},
                         c[2] = {numbers.point(), numbers.point()};
        const auto way = [](const glm::dvec3(&p)[2]) {
            return VectorPolynomial::between(glm::tvec3<Real>(p[0]), glm::tvec3<Real>(p[1]));
        };
        const Polynomial p = dot(way(a), cross(way(b), way(c)));
        const ExactPolynomial exact = determinant(ExactWay::of(a), ExactWay::of(b), ExactWay::of(c));
        for (int k = 0; k <= 3; ++k) ASSERT_NEAR(static_cast<double>(exact.rounded()[k] - p[k]), 0.0, 4e-16);
        const double u = numbers.between(0, 1);
        const Real value = p.at(static_cast<Real>(u));
        ASSERT_TRUE(std::abs(value) < 1e-17L || exact.signAt(u) == (value > 0 ? 1 : -1));
        // A determinant with twice the same row is 0, at all times.
        ASSERT_EQ(determinant(ExactWay::of(a), ExactWay::of(b), ExactWay::of(a)).signAt(u), 0);
        ASSERT_EQ(determinant(ExactWay::of(a), ExactWay::of(b), ExactWay::of(a)).rounded().largest(), 0);
    }
}

/// (u - r)^3 is 0 at r and nowhere else, however near.
TEST(ExactPolynomial, SignsAreExact) {
    const double r = 0.3;
    const ExactPolynomial less(Expansion(-r), Expansion::difference(1.0, r));
    const ExactPolynomial cube = less * less * less;
    EXPECT_EQ(cube.signAt(r), 0);
    EXPECT_EQ(cube.signAt(std::nextafter(r, 0.0)), -1);
    EXPECT_EQ(cube.signAt(std::nextafter(r, 1.0)), 1);
    EXPECT_EQ((cube * -2.0).signAt(std::nextafter(r, 1.0)), -1);
    EXPECT_EQ((cube - cube).signAt(0.7), 0);
    EXPECT_EQ((cube + cube).signAt(0.7), 1);
}

}  // namespace
}  // namespace timeshade::oracle
