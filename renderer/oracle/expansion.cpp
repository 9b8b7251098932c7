#include "oracle/expansion.h"

#include <cmath>

namespace timeshade::oracle {

Expansion Expansion::difference(double a, double b) {
    Expansion result(a);
    result.add(-b);
    return result;
}

/// Grow-Expansion (Shewchuk, theorem 10): two-sums carry the value upwards and leave each rounding error behind. Parts
/// that are zero are dropped.
void Expansion::add(double value) {
    double carry = value;
    std::size_t kept = 0;
    for (const double part : parts_) {
        const double sum = carry + part;
        const double partShare = sum - carry;
        const double error = (carry - (sum - partShare)) + (part - partShare);
        carry = sum;
        if (error != 0.0) parts_[kept++] = error;
    }
    parts_.resize(kept);
    if (carry != 0.0) parts_.push_back(carry);
}

Expansion& Expansion::operator+=(const Expansion& other) {
    for (const double part : other.parts_) add(part);
    return *this;
}

Expansion& Expansion::operator-=(const Expansion& other) {
    for (const double part : other.parts_) add(-part);
    return *this;
}

Expansion Expansion::operator*(double factor) const {
    Expansion result;
    for (const double part : parts_) {
        const double product = part * factor;
        result.add(std::fma(part, factor, -product));  // what the product lost: exactly representable
        result.add(product);
    }
    return result;
}

Expansion Expansion::operator*(const Expansion& other) const {
    Expansion result;
    for (const double part : other.parts_) result += *this * part;
    return result;
}

int Expansion::sign() const { return parts_.empty() ? 0 : (parts_.back() > 0.0 ? 1 : -1); }

double Expansion::estimate() const {
    double sum = 0.0;
    for (const double part : parts_) sum += part;
    return sum;
}

Expansion determinant(const ExactVector& a, const ExactVector& b, const ExactVector& c) {
    const auto minor = [](const Expansion& p, const Expansion& q, const Expansion& r, const Expansion& s) {
        Expansion result = p * q;
        result -= r * s;
        return result;
    };
    Expansion sum = a.x * minor(b.y, c.z, b.z, c.y);
    sum += a.y * minor(b.z, c.x, b.x, c.z);
    sum += a.z * minor(b.x, c.y, b.y, c.x);
    return sum;
}

}  // namespace timeshade::oracle
