#include "oracle/cutout_cover.h"

#include <algorithm>
#include <cmath>

#include "oracle/segment_triangle.h"

namespace timeshade::oracle {

namespace {

constexpr double farthestCoordinate = 1e9;  // beyond, and for what is no number, 0 counts

int texelOf(double number, int size, Wrap wrap) {
    const auto n = static_cast<long long>(number);
    const long long period = wrap == Wrap::Mirror ? 2LL * size : size;
    const long long inPeriod = ((n % period) + period) % period;
    switch (wrap) {
    case Wrap::Repeat: return static_cast<int>(inPeriod);
    case Wrap::Mirror: return static_cast<int>(std::min(inPeriod, period - 1 - inPeriod));
    case Wrap::Clamp: break;
    }
    return static_cast<int>(std::clamp<long long>(n, 0, size - 1));
}

double finite(double coordinate) { return std::abs(coordinate) < farthestCoordinate ? coordinate : 0.0; }

/// In 1/255.
double alphaAt(const Cutouts& cutouts, const Cutouts::Sheet& sheet, const glm::dvec2& coordinates) {
    const auto texel = [&](double x, double y) {
        const int column = texelOf(x, sheet.width, sheet.wrapU), row = texelOf(y, sheet.height, sheet.wrapV);
        const std::size_t place =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(sheet.width) + static_cast<std::size_t>(column);
        return static_cast<double>(cutouts.alphas()[sheet.first + place]);
    };
    const double x = finite(coordinates.x) * sheet.width, y = finite(coordinates.y) * sheet.height;
    if (sheet.nearest) return texel(std::floor(x), std::floor(y));
    const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
    const double right = x - 0.5 - left, down = y - 0.5 - top;
    const auto between = [](double a, double b, double share) { return a + (b - a) * share; };
    return between(between(texel(left, top), texel(left + 1.0, top), right),
                   between(texel(left, top + 1.0), texel(left + 1.0, top + 1.0), right), down);
}

}  // namespace

CutoutCover::Cover CutoutCover::at(std::uint32_t triangle, const glm::dvec2& barycentrics, double slack) const {
    if (!isCutOut(triangle)) return {};
    const MeshTopology& topology = *mesh_->topology;
    const Cutouts::Sheet& sheet = cutouts_->sheet(topology.triangleMaterials[triangle]);
    const glm::u32vec3& v = topology.triangles[triangle];
    const glm::dvec2 first(topology.textureCoordinates[v.x]);
    const glm::dvec2 a = glm::dvec2(topology.textureCoordinates[v.y]) - first,
                     b = glm::dvec2(topology.textureCoordinates[v.z]) - first;
    const glm::dvec2 here = first + barycentrics.x * a + barycentrics.y * b;
    const auto covers = [&](const glm::dvec2& place) {
        return alphaAt(*cutouts_, sheet, place) >= static_cast<double>(sheet.threshold);
    };
    Cover cover;
    cover.covers = covers(here);
    if (slack <= 0.0) return cover;
    // Floats round the coordinates themselves, too.
    const glm::dvec2 off = slack * (glm::abs(a) + glm::abs(b)) + marginalShare * 0.25 * glm::abs(here);
    if (!(off.x * sheet.width < 0.5 && off.y * sheet.height < 0.5)) {
        cover.doubtful = true;
        return cover;
    }
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            cover.doubtful = cover.doubtful || covers(here + off * glm::dvec2(x, y)) != cover.covers;
    return cover;
}

CutoutCover::Cover CutoutCover::onLine(std::uint32_t triangle, const glm::dvec3 (&vertices)[3], const glm::dvec3& from,
                                       const glm::dvec3& to, double s) const {
    if (!isCutOut(triangle)) return {};
    const glm::dvec3 a = vertices[1] - vertices[0], b = vertices[2] - vertices[0], normal = glm::cross(a, b);
    const glm::dvec3 direction = to - from, p = from + s * direction - vertices[0];
    const double area = glm::dot(normal, normal);
    const glm::dvec2 barycentrics =
        glm::dvec2(glm::dot(glm::cross(p, b), normal), glm::dot(glm::cross(a, p), normal)) / area;
    const double cosine = std::abs(glm::dot(direction, normal)) / (glm::length(direction) * std::sqrt(area));
    const double moved = marginalShare * (glm::length(from) + std::abs(s) * glm::length(direction));
    const double longest = std::max(glm::length(a), glm::length(b));
    return at(triangle, barycentrics, moved * longest / (std::sqrt(area) * std::max(cosine, 1e-12)));
}

}  // namespace timeshade::oracle
