#pragma once

#include "oracle/seen_segments.h"
#include "oracle/swept_line.h"

namespace timeshade::oracle {

/// The way of a segment's receiver, and the light seen from it. Over the segment, t runs from 0 to 1; all positions are
/// less `origin`, a point near the receiver, so that little cancels. With d the ray's direction, n the normal of the
/// receiver's triangle, w from the eye to it,
///
///     E = d . n (cubic),  W = w . n (cubic),  p = eye + d W / E,  P = E p = E eye + W d (of degree 4)
///
/// and with l from the receiver to the light, or against the direction of light as long as its map is deep,
///
///     A = E l (of degree 4),  M = P x l (of degree 5; p x l is the same for every point of the line).
class ReceiverWay {
  public:
    ReceiverWay(const FramePlan& plan, const PositionRay& ray, const SeenSegment& segment,
                const MovingTriangles& triangles);

    double timeOf(double t) const { return segment_.u0 + t * (segment_.u1 - segment_.u0); }
    /// The definition's receiver at t.
    Receiver receiverAt(double t) const;
    /// A vertex of a triangle over the segment.
    VectorPolynomial vertexOf(std::uint32_t id, int vertex) const;
    const SeenSegment& segment() const { return segment_; }
    const MovingTriangles& triangles() const { return triangles_; }
    const Polynomial& sum() const { return sum_; }
    const VectorPolynomial& position() const { return position_; }
    const VectorPolynomial& toLight() const { return toLight_; }
    const VectorPolynomial& moment() const { return moment_; }
    Real positionError() const { return positionError_; }  ///< of a coefficient of P
    Real lightError() const { return lightError_; }        ///< of one of M

    /// Adds t between which the receiver's facing and its being in the cone do not change.
    void addTestedChanges(std::vector<double>& times) const;
    /// Adds t at which the clearance begins to grow otherwise, and the clearance as linear functions between them.
    std::vector<double> clearanceCuts() const;
    Polynomial clearanceBetween(double t0, double t1) const;
    /// False only where no triangle inside the box ever lies between the receiver and the light.
    bool mayShadow(const SweptBox& box, double pad) const;

  private:
    using RealVector = glm::tvec3<Real>;
    VectorPolynomial part(const glm::dvec3& open, const glm::dvec3& close, bool asPoint) const;
    void makeLight();
    void makeExtent();
    double clearanceAt(double t) const;

    const FramePlan& plan_;
    const PositionRay& ray_;
    SeenSegment segment_;
    const MovingTriangles& triangles_;
    RealVector origin_{0};
    Polynomial sum_;
    VectorPolynomial normal_, position_, light_, toLight_, moment_;
    Real positionError_ = 0, lightError_ = 0;
    glm::dvec3 low_{0.0}, high_{0.0};
    std::optional<SweptLine> line_;
};

}  // namespace timeshade::oracle
