#pragma once

#include <initializer_list>
#include <optional>
#include <vector>

#include "oracle/exact_polynomial.h"
#include "oracle/swept_bvh.h"

namespace timeshade::oracle {

/// The camera ray through one place of the image, at both ends of the shutter: eye and direction are linear in u
/// between. Relative to the plan's origin; taken as exact.
struct PositionRay {
    glm::dvec3 eye[2], direction[2];
    double nearDistance = 0.0;  ///< in lengths of the direction
};

/// A time inside (a, b), near to the middle, of as few bits as that allows; nothing where no double lies between.
std::optional<double> timeBetween(double a, double b);

struct TimeSpan {
    double begin = 0.0, end = 0.0;
};

/// When a position's ray meets one triangle from a side that the camera sees, beyond the near distance. With d the
/// ray's direction, w_i from the eye to the vertices, n the triangle's normal (not of unit length), all at one time u:
///
///     e_i = det[d, w_j, w_k] (cubic),    E = d . n = e_0 + e_1 + e_2 (cubic),    W = w_0 . n (cubic)
///
/// the triangle is met where no two e_i have opposite signs and E is not 0, at the depth W / E; E < 0 is its front.
/// Signs are exact for the given numbers: in Real where its error bound allows, else in expansions. Times are those of
/// roots, whose error is that of a double but where an edge hardly moves: it is moved by less than 2^-40 of the
/// greatest distance that it has from the ray.
class SeenTriangle {
  public:
    SeenTriangle(const PositionRay& ray, const MovingTriangles& triangles, std::uint32_t id);

    std::uint32_t id() const { return id_; }
    const std::vector<TimeSpan>& spans() const { return spans_; }  ///< in ascending order, apart; between exact signs
    bool seenAt(double u) const;
    /// Both are met at u: is this one nearer, or of two at exactly one depth the one with the lower number?
    bool isBefore(const SeenTriangle& other, double u) const;
    /// Adds the roots of W E' - W' E (of degree 6): the times at which their planes change their order along the ray.
    void addOrderChanges(const SeenTriangle& other, std::vector<double>& times) const;

  private:
    struct Function {
        Polynomial p;
        Real error = 0;  ///< of a coefficient
    };
    enum Which { Edge0, Edge1, Edge2, Sum, Plane, Near, functionCount };
    struct Exact {
        ExactPolynomial sum, plane;
    };

    bool makeFunctions();  ///< false where the triangle is clearly never seen; some are missing then
    bool isNeverSeen(std::initializer_list<Which> which) const;
    void makeSpans();
    ExactPolynomial exact(Which which) const;
    int signAt(Which which, double u) const;
    Function orderTo(const SeenTriangle& other) const;
    ExactPolynomial exactOrderTo(const SeenTriangle& other) const;
    static bool isVague(const Function& f);
    static Function rounded(const ExactPolynomial& exact);
    static std::optional<int> signOf(const Function& f, double u);

    const PositionRay& ray_;
    std::uint32_t id_;
    bool twoSided_;
    glm::dvec3 vertices_[3][2];
    Function functions_[functionCount];
    std::vector<TimeSpan> spans_;
};

}  // namespace timeshade::oracle
